// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"
#include "app/cost_map/cost_map.h"

namespace app {

/// What colours mean in a map.
struct CostLegend {
    Interval range{};            ///< of the cost, from the palest colour to the strongest
    std::vector<double> ticks{}; ///< its ends, and round numbers between, ascending
    struct Share {
        std::uint32_t cheapest; ///< as in CostMap
        std::size_t cells;
    };
    std::vector<Share> shares{}; ///< of a map of the cheapest: the most first

    double shareOf(double cost) const; ///< where in the range: 0 to 1
};

/// Of a map with one cell at least. Of times the range leaves out the outermost hundredth: what
/// something else in the computer took.
CostLegend legendOf(const CostMap& map);

} // namespace app
