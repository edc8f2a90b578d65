// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/edit_command.h"

namespace app {

/// Adds, moves or removes guides of the page.
class SetGuides : public EditCommand {
public:
    static constexpr CommandKind row{"set-guides", "Adds, moves or removes guides"};

    SetGuides(EditedDocument& document, Guides guides, const QString& text);
};

/// Sets how the page is divided among sheets of paper.
class SetSheets : public EditCommand {
public:
    static constexpr CommandKind row{"set-sheets", "Sets how the page is divided among sheets"};

    SetSheets(EditedDocument& document, std::optional<PageSheets> sheets, const QString& text);
};

/// Sets size, place, scale and margins of the page. At another scale, strokes are as wide on paper
/// as before, and no other length of the drawing changes.
class ChangePage : public EditCommand {
public:
    static constexpr CommandKind row{"change-page", "Changes the page or the drawing's scale"};

    /// `containers` is the tree with the styles of new objects, if they change.
    ChangePage(EditedDocument& document, const Page& page, std::optional<Containers> containers);
};

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
