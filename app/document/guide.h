// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace app {

/// A straight line on the page that is never cut, printed or exported: points snap to it.
struct Guide {
    int axis;  ///< 0: vertical, at x; 1: horizontal, at y
    double at; ///< in user units
    friend bool operator==(const Guide&, const Guide&) = default;
};

struct Guides {
    static constexpr std::size_t most = 1000; ///< guides of a page
    std::vector<Guide> list{};                ///< the newest last
    friend bool operator==(const Guides&, const Guides&) = default;
};

} // namespace app
