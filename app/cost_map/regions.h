// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/cost_map.h"

namespace app {

/// Connected cells that are alike: of one cost, or with the same cheapest algorithms.
struct CostRegion {
    std::size_t cells = 0;
    int column = 0, row = 0; ///< of a cell farthest from the border, near the middle
    int reach = 0;           ///< cells of the region around it in every direction
};

/// All regions of a whole map, in the order of their first cells.
std::vector<CostRegion> regionsOf(const CostMap& map);

} // namespace app
