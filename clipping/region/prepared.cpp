// SPDX-License-Identifier: MIT
#include "clipping/region/prepared.h"

#include "clipping/ieee_numbers.h"
#include "clipping/region/convex.h"

#include <cassert>

namespace clipping {

PreparedRegion::Data::Data(const Region& region)
    : fold(region), edges(edgesOf(region)), grid(edges, region.steps.size()),
      keepsNone(fold.keeps(fold.inNone())), convex(convexRegion(region))
{
    for (const Region::Step& step : region.steps) {
        rules.push_back(step.area.rule);
        isFinite = isFinite && clipping::isFinite(step.area);
    }
    keepsReference.reserve(grid.cells());
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) {
        RegionFold::Words state = fold.inNone();
        for (const auto& [step, winding] : grid.windingsIn(cell))
            if (fills(step, winding))
                RegionFold::flip(state, step);
        keepsReference.push_back(fold.keeps(state));
    }
}

PreparedRegion::PreparedRegion(const Region& region) : data_(std::make_shared<Data>(region)) {}

PreparedRegion::Edge PreparedRegion::edge(std::uint32_t number) const
{
    const auto found = std::ranges::lower_bound(data_->edges, number, {}, &AreaEdge::number);
    assert(found != data_->edges.end() && found->number == number);
    return {found->step, found->segment};
}

} // namespace clipping
