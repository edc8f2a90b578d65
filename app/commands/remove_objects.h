// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Removes objects. Undo puts them back in their places.
class RemoveObjects : public EditCommand {
public:
    static constexpr CommandKind row{"remove-objects", "Removes objects"};

    RemoveObjects(EditedDocument& document, const ObjectRanges& objects, const QString& text);
    RemoveObjects(EditedDocument& document, const ObjectRanges& objects);
};

} // namespace app
