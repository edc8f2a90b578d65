// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace app {

/// Numbers of consecutive objects that are consecutive too.
struct NumberRun {
    static constexpr std::uint32_t none = ~std::uint32_t(0); ///< as `first`: the objects have none
    std::uint32_t first = none, count = 0;
    friend bool operator==(const NumberRun&, const NumberRun&) = default;
};
using NumberRuns = std::vector<NumberRun>;

/// Adds the numbers of the next objects, to the last run if they go on with it.
inline void append(NumberRuns& runs, const NumberRun& more)
{
    if (!runs.empty()) {
        NumberRun& last = runs.back();
        const bool goesOn =
            more.first == NumberRun::none
                ? last.first == NumberRun::none
                : last.first != NumberRun::none && last.first + last.count == more.first;
        if (goesOn) {
            last.count += more.count;
            return;
        }
    }
    runs.push_back(more);
}

} // namespace app
