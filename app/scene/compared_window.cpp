// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/compared_window.h"

#include <algorithm>

namespace app {

static auto first(std::vector<ClipWindow>& list)
{
    return std::ranges::find_if(
        list, [](const ClipWindow& w) { return w.visible && axisAlignedBox(w.shape); });
}

std::optional<clipping::Window> firstWindow(const ClipWindows& windows)
{
    for (const ClipWindow& window : windows.list)
        if (const auto box = axisAlignedBox(window.shape); box && window.visible)
            return box;
    return std::nullopt;
}

ClipWindows withWindow(ClipWindows windows, const clipping::Window& window)
{
    if (const auto old = first(windows.list); old != windows.list.end())
        old->shape = RectangleShape{window};
    else if (windows.list.size() < ClipWindows::most)
        windows.list.push_back({.shape = RectangleShape{window}});
    return windows;
}

ClipWindows withoutWindow(ClipWindows windows)
{
    if (const auto old = first(windows.list); old != windows.list.end())
        windows.list.erase(old);
    return windows;
}

ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page)
{
    const auto window = firstWindow(windows);
    return {window.value_or(page.rectangle()), !window};
}

} // namespace app
