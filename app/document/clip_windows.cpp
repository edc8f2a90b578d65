// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/clip_windows.h"

namespace app {

std::vector<std::size_t> numbersInEffect(const ClipWindows& windows)
{
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < windows.list.size(); ++i) {
        if (!windows.list[i].visible)
            continue;
        if (windows.list[i].operation == WindowOperation::Replace)
            numbers.clear();
        numbers.push_back(i);
    }
    return numbers;
}

ClipWindows inEffect(const ClipWindows& windows)
{
    ClipWindows all{{}, windows.keep};
    for (const std::size_t number : numbersInEffect(windows))
        all.list.push_back(windows.list[number]);
    if (!all.list.empty() && all.list.front().operation == WindowOperation::Replace)
        all.list.front().operation = WindowOperation::Add;
    return all;
}

std::optional<std::size_t> replacing(const ClipWindows& windows, std::size_t number)
{
    const auto numbers = numbersInEffect(windows);
    const bool isReplaced =
        !numbers.empty() && number < numbers.front() && windows.list[number].visible;
    return isReplaced ? std::optional(numbers.front()) : std::nullopt;
}

} // namespace app
