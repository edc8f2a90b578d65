// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Moves objects.
class MoveObjects : public EditCommand {
public:
    static constexpr CommandKind row{"move-objects", "Moves objects"};

    MoveObjects(EditedDocument& document, const ObjectRanges& objects, const Point& by,
                Merging merging = Merging::Never);
};

/// Moves the object by the placement.
void place(ObjectRow& object, const Placement& where);

} // namespace app
