// SPDX-License-Identifier: MIT
#include "clipping/area/both_sides.h"

#include "clipping/ieee_numbers.h"

namespace clipping {

void BothSides::turn(std::uint32_t step, int left, int right)
{
    Beside& beside = beside_[step];
    if (beside.left == 0 && beside.right == 0)
        touched_.push_back(step);
    const auto change = [&](int& winding, int by, RegionFold::Words& state) {
        if (region_.fills(step, winding) != region_.fills(step, winding + by))
            RegionFold::flip(state, step);
        winding += by;
    };
    change(beside.left, left, left_);
    change(beside.right, right, right_);
}

void BothSides::enter(const SweptLine& swept, EdgesNear& edges)
{
    for (const std::uint32_t step : touched_)
        beside_[step] = {};
    touched_.clear();
    left_ = right_ = region_.fold.inNone();
    if (!region_.edges.empty() && contains(region_.grid.box(), swept.segment.a))
        edges.enter(swept, region_.grid, false,
                    [&](std::uint32_t step, int left, int right) { turn(step, left, right); });
}

} // namespace clipping
