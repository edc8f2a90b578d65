// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Adds objects to a container, above all that is in it.
class AddObjects : public EditCommand {
public:
    static constexpr CommandKind row{"add-objects", "Adds objects on top of a layer"};

    /// `text` names the step: "Draw line", "Paste". Not empty; `objects` neither.
    AddObjects(EditedDocument& document, const Objects& objects, ContainerId into,
               const QString& text);

    /// Where they are while this command is in force.
    const ObjectRange& place() const { return place_; }

private:
    ObjectRange place_;
};

} // namespace app
