// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/fold.h"
#include "clipping/region/grid.h"

#include <memory>

namespace clipping {

struct ConvexRegion;

/// A region with its edges ordered and in a grid, so that lines are clipped fast.
struct PreparedRegion::Data {
    explicit Data(const Region& region);

    RegionFold fold;
    std::vector<FillRule> rules; ///< of the steps' areas
    std::vector<AreaEdge> edges; ///< ordered by number
    SearchGrid grid;
    bool isFinite = true;                       ///< whether all numbers are
    bool keepsNone;                             ///< whether points in no area are kept
    std::vector<std::uint8_t> keepsReference;   ///< for each cell, whether its reference is kept
    std::shared_ptr<const ConvexRegion> convex; ///< null unless it is one (convex.h)

    bool fills(std::uint32_t step, int winding) const
    {
        return rules[step] == FillRule::NonZero ? winding != 0 : (winding & 1) != 0;
    }
};

} // namespace clipping
