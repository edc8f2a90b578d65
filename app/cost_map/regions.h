// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cost_map/cost_map.h"

namespace app {

/// Cells that hang together and are alike: of one cost, or of the same cheapest algorithms.
struct CostRegion {
    std::size_t cells = 0;
    int column = 0, row = 0; ///< of the cells farthest from its border, one in the middle
    int reach = 0;           ///< how far: so many cells in every direction are of the region
};

/// All regions of a whole map, as they begin from its first cell on.
std::vector<CostRegion> regionsOf(const CostMap& map);

} // namespace app
