// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Draws, moves or resizes the clip window that tools act on (see `withWindow`).
class SetWindow : public EditCommand {
public:
    static constexpr CommandKind row{"set-window", "Draws, moves or resizes the clip window"};

    SetWindow(EditedDocument& document, const clipping::Window& window,
              Merging merging = Merging::Never);
};

} // namespace app
