// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/set_page_parts.h"
#include "app/scene/compared_window.h"

#include <algorithm>

/// The clip windows with the first visible axis-aligned rectangle at `window`; it is added if there
/// is none.
inline app::ClipWindows withWindow(app::ClipWindows windows, const clipping::Window& window)
{
    const auto isRectangle = [](const app::ClipWindow& each) {
        return each.visible && app::axisAlignedBox(each.shape);
    };
    const auto old = std::ranges::find_if(windows.list, isRectangle);
    if (old == windows.list.end())
        windows.list.push_back({.shape = app::RectangleShape{window}});
    else
        old->shape = app::RectangleShape{window};
    return windows;
}

/// The command that draws or moves that window.
inline app::SetWindows* windowStep(app::EditedDocument& document, const clipping::Window& window,
                                   app::Merging merging = app::Merging::Never)
{
    return new app::SetWindows(
        document, withWindow(document.now().windows(), window),
        document.now().windows().list.empty() ? "Draw clip window" : "Move clip window", merging);
}
