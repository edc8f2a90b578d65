// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/compared_window.h"

#include <algorithm>

namespace app {

std::optional<std::size_t> actedOn(const ClipWindows& windows, std::size_t chosen)
{
    const auto& list = windows.list;
    if (chosen < list.size() && list[chosen].visible)
        return chosen;
    const auto visible = std::ranges::find_if(list, &ClipWindow::visible);
    return visible == list.end() ? std::nullopt : std::optional(visible - list.begin());
}

std::optional<clipping::Window> firstWindow(const ClipWindows& windows)
{
    for (const ClipWindow& window : windows.list)
        if (const auto box = axisAlignedBox(window.shape); box && window.visible)
            return box;
    return std::nullopt;
}

ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page,
                              std::optional<std::size_t> first)
{
    std::optional<clipping::Window> window;
    if (first && windows.list[*first].visible)
        window = axisAlignedBox(windows.list[*first].shape);
    if (!window)
        window = firstWindow(windows);
    return {window.value_or(page.rectangle()), !window};
}

} // namespace app
