// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Turns strokes into filled areas (app/cut/stroke_area.h).
class OutlineStrokes : public EditCommand {
public:
    static constexpr CommandKind row{"outline-strokes", "Turns strokes into filled areas"};

    OutlineStrokes(EditedDocument& document, Edit edit, const QString& text)
        : EditCommand(row, document, std::move(edit), text)
    {
    }
};

} // namespace app
