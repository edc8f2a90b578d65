// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Adds objects to containers, on top of each container's content.
class AddObjects : public EditCommand {
public:
    static constexpr CommandKind row{"add-objects", "Adds objects on top of a layer"};

    /// `text` names the step: "Draw line", "Paste". Neither `text` nor `objects` may be empty.
    AddObjects(EditedDocument& document, const Objects& objects, ContainerId into,
               const QString& text);
    AddObjects(EditedDocument& document, Edit adding, const QString& text); ///< see app::adding
};

/// Removes objects. Undo puts them back in their places.
class RemoveObjects : public EditCommand {
public:
    static constexpr CommandKind row{"remove-objects", "Removes objects"};

    RemoveObjects(EditedDocument& document, const ObjectRanges& objects, const QString& text);
    RemoveObjects(EditedDocument& document, const ObjectRanges& objects);
};

} // namespace app
