// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/undo_command.h"

#include "app/base/text.h"

namespace app {

// Commands with different texts are different steps.
QString UndoCommand::mergeKey() const
{
    return merging_ == Merging::Never ? QString() : latin(kind_->key) + u'/' + text_;
}

} // namespace app
