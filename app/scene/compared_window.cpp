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

ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page,
                              std::optional<std::size_t> first)
{
    const auto at = [&](std::size_t number) -> std::optional<ComparedWindow> {
        const ClipWindow& window = windows.list[number];
        const auto box = window.visible ? axisAlignedBox(window.shape) : std::nullopt;
        return box ? std::optional(ComparedWindow{.window = *box, .number = number}) : std::nullopt;
    };
    if (const auto chosen = first ? at(*first) : std::nullopt)
        return *chosen;
    for (std::size_t number = 0; number < windows.list.size(); ++number)
        if (const auto found = at(number))
            return *found;
    const bool cut = std::ranges::any_of(windows.list, &ClipWindow::visible);
    return {.window = page.rectangle(), .isPage = true, .comparable = !cut};
}

} // namespace app
