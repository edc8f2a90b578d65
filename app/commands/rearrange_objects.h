// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Groups and ungroups objects, changes their painting order, and moves them and layers between
/// layers (regrouping.h, stacking.h).
class RearrangeObjects : public EditCommand {
public:
    static constexpr CommandKind row{"rearrange-objects", "Groups, orders or moves objects"};

    RearrangeObjects(EditedDocument& document, Edit edit, const QString& text)
        : EditCommand(row, document, std::move(edit), text)
    {
    }
};

} // namespace app
