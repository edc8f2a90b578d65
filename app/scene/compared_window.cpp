// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/compared_window.h"

#include <algorithm>

namespace app {

std::optional<std::size_t> actedOn(const ClipWindows& windows, std::size_t chosen)
{
    const auto& list = windows.list;
    if (chosen < list.size() && list[chosen].visible)
        return chosen;
    const auto numbers = numbersInEffect(windows);
    return numbers.empty() ? std::nullopt : std::optional(numbers.front());
}

ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page,
                              std::optional<std::size_t> first)
{
    std::vector<std::size_t> numbers = numbersInEffect(windows);
    const bool cut = !numbers.empty();
    if (first && std::ranges::binary_search(numbers, *first))
        numbers.insert(numbers.begin(), *first);
    for (const std::size_t number : numbers)
        if (const auto box = axisAlignedBox(windows.list[number].shape))
            return {.window = *box, .number = number};
    return {.window = page.rectangle(), .isPage = true, .comparable = !cut};
}

} // namespace app
