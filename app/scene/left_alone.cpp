// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/left_alone.h"

#include <algorithm>

namespace app {

std::vector<std::size_t> leftAlone(const ClipRegion& region, const Variant& variant)
{
    std::vector<std::size_t> steps;
    for (std::size_t i = 0; i < region.steps.size(); ++i)
        if (!limitText(variant, needsOf(region.steps[i])).isEmpty())
            steps.push_back(i);
    const bool allAdd = std::ranges::all_of(steps, [&region](std::size_t step) {
        return region.steps[step].operation == WindowOperation::Add;
    });
    return allAdd && region.keep == Keep::Inside ? steps : std::vector<std::size_t>();
}

ClipWindows without(ClipWindows windows, std::span<const std::size_t> steps)
{
    const auto numbers = numbersInEffect(windows);
    for (const std::size_t step : steps)
        windows.list[numbers[step]].shape = RectangleShape{{{1, 1}, {0, 0}}};
    return windows;
}

} // namespace app
