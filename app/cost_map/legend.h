// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"
#include "app/cost_map/cost_map.h"

namespace app {

/// The meaning of a map's colours.
struct CostLegend {
    Interval range{};            ///< of the cost, from the palest colour to the strongest
    std::vector<double> ticks{}; ///< its ends, and round numbers between, ascending
    struct Share {
        std::uint32_t cheapest; ///< as in CostMap
        std::size_t cells;
    };
    std::vector<Share> shares{}; ///< in a map of the cheapest: the largest share first

    double shareOf(double cost) const; ///< position in the range: 0 to 1
};

/// The legend of a map with at least one cell. For times, the range leaves out the outermost
/// hundredth, which other programs disturbed.
CostLegend legendOf(const CostMap& map);

} // namespace app
