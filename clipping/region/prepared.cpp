// SPDX-License-Identifier: MIT
#include "clipping/region/prepared.h"

#include "clipping/ieee_numbers.h"
#include "clipping/region/convex.h"

#include <algorithm>
#include <cassert>

namespace clipping {
namespace {

std::vector<FillRule> rulesOf(const Region& region)
{
    std::vector<FillRule> rules;
    for (const Region::Step& step : region.steps)
        rules.push_back(step.area.rule);
    return rules;
}

constexpr double cellsForEach = 2, fewestCells = 16;
constexpr double fineCellsForEach = 64, fewestFineCells = 1024;
constexpr std::size_t fineMostEdges = 1024; // with more, the usual cells are small enough
constexpr std::size_t manySegments = 4096;
constexpr std::size_t asManyAsATree = 64; // edges that a grid lists while a tree divides one

} // namespace

RegionGrid::RegionGrid(const PreparedRegion::Data& region, double each, double fewest)
    : SearchGrid(region.edges, region.rules.size(), each, fewest)
{
    keepsReference.reserve(cells());
    RegionFold::Words state;
    for (std::size_t cell = 0; cell < cells(); ++cell) {
        if (cell > 0 && std::ranges::equal(windingsIn(cell - 1), windingsIn(cell))) {
            keepsReference.push_back(keepsReference.back());
            continue;
        }
        state = region.fold.inNone();
        for (const auto& [step, winding] : windingsIn(cell))
            if (region.fills(step, winding))
                RegionFold::flip(state, step);
        keepsReference.push_back(region.fold.keeps(state));
    }
}

PreparedRegion::Data::Data(const Region& region)
    : fold(region), rules(rulesOf(region)), edges(edgesOf(region)),
      isFinite(std::ranges::all_of(region.steps,
                                   [](const auto& step) { return clipping::isFinite(step.area); })),
      keepsNone(fold.keeps(fold.inNone())), grid(*this, cellsForEach, fewestCells),
      convex(convexRegion(region))
{
}

const RegionGrid& PreparedRegion::Data::gridFor(std::size_t segments) const
{
    if (segments < manySegments || edges.empty() || edges.size() > fineMostEdges)
        return grid;
    const std::scoped_lock one(making_);
    if (!fine_)
        fine_ = std::make_unique<RegionGrid>(*this, fineCellsForEach, fewestFineCells);
    return *fine_;
}

const EdgeTree* PreparedRegion::Data::treeAfter(std::size_t listedTooMany) const
{
    if (const EdgeTree* const made = madeTree_)
        return made;
    if (listedTooMany == 0 || edges.empty())
        return nullptr;
    listedTooMany_ += listedTooMany;
    if (listedTooMany_ < asManyAsATree * edges.size() || !EdgeTree::suits(grid.box()))
        return nullptr;
    const std::scoped_lock one(making_);
    if (!tree_)
        tree_ = std::make_unique<EdgeTree>(edges, rules.size(), grid.box());
    return madeTree_ = tree_.get();
}

PreparedRegion::PreparedRegion(const Region& region) : data_(std::make_shared<Data>(region)) {}

PreparedRegion::Edge PreparedRegion::edge(std::uint32_t number) const
{
    const auto found = std::ranges::lower_bound(data_->edges, number, {}, &AreaEdge::number);
    assert(found != data_->edges.end() && found->number == number);
    return {found->step, found->segment};
}

} // namespace clipping
