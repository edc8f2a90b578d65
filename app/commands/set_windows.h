// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Adds, removes or changes clip windows, or sets which side of them is kept.
class SetWindows : public EditCommand {
public:
    static constexpr CommandKind row{"set-windows", "Changes the list of clip windows"};

    SetWindows(EditedDocument& document, ClipWindows windows, const QString& text,
               Merging merging = Merging::Never)
        : EditCommand(row, document, {.windows = std::move(windows)}, text, merging)
    {
    }
};

} // namespace app
