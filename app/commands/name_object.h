// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/text.h"
#include "app/commands/edit_command.h"

namespace app {

/// Gives an object a name of its own, which is its id in SVG; an empty one takes it away.
class NameObject : public EditCommand {
public:
    static constexpr CommandKind row{"name-object", "Gives an object a name"};

    NameObject(EditedDocument& document, std::size_t object, const QString& id)
        : EditCommand(
            row, document,
            changed(document.now(), ObjectRanges{object},
                    [&id](ObjectRow& changed, StyleTable&) { changed.particulars.own().id = id; }),
            id.isEmpty() ? Text::tr("Remove name") : Text::tr("Name %1").arg(id))
    {
    }
};

} // namespace app
