// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/undo_command.h"

#include "app/latin.h"

namespace app {

// What has another name for people is another step to them.
QString UndoCommand::mergeKey() const
{
    return merging_ == Merging::Never ? QString() : latin(kind_->key) + u'/' + text_;
}

} // namespace app
