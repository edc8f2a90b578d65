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

void BothSides::enter(const SweptLine& swept)
{
    for (const std::uint32_t step : touched_)
        beside_[step] = {};
    touched_.clear();
    left_ = right_ = region_.fold.inNone();
    const SearchGrid& grid = region_.grid;
    const glm::dvec2& start = swept.segment.a;
    if (region_.edges.empty() || !contains(grid.box(), start))
        return;
    const std::size_t cell = grid.cellOf(start);
    for (const auto& [step, winding] : grid.windingsIn(cell))
        turn(step, winding, winding);
    const Reference reference = grid.reference(cell);
    const BesideStart left{swept.line, 1}, right{swept.line, -1};
    for (const std::uint32_t i : grid.edgesIn(cell, cell)) {
        const auto& [segment, step, number] = region_.edges[i];
        const int ofLeft = windingStep(segment, reference, left);
        const int ofRight = windingStep(segment, reference, right);
        if (ofLeft != 0 || ofRight != 0)
            turn(step, ofLeft, ofRight);
    }
}

} // namespace clipping
