// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/edges_near.h"

namespace clipping {

/// The winding numbers of a region's areas on both sides of a line, infinitely near to it, and
/// whether the region keeps the points there. Keeps its memory from one line to the next.
class BothSides {
public:
    explicit BothSides(const PreparedRegion::Data& region)
        : region_(region), beside_(region.rules.size())
    {
    }

    /// Starts just after the start of a segment that is not a point. The edges are of the same
    /// region.
    void enter(const SweptLine& swept, EdgesNear& edges);
    /// Passes edges of one area: its winding numbers change.
    void turn(std::uint32_t step, int left, int right);

    bool keepsLeft() const { return region_.fold.keeps(left_); }
    bool keepsRight() const { return region_.fold.keeps(right_); }

private:
    struct Beside {
        int left = 0, right = 0;
    };

    const PreparedRegion::Data& region_;
    std::vector<Beside> beside_;         ///< of each step
    std::vector<std::uint32_t> touched_; ///< the steps for which this is not the default
    RegionFold::Words left_, right_;
};

} // namespace clipping
