// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/meeting.h"
#include "clipping/region/prepared.h"

#include <utility>

namespace clipping {

/// Finds the edges of a region that are near: in a grid of it, and where its cells list very many,
/// soon in a tree. Keeps its memory.
class EdgesNear {
public:
    explicit EdgesNear(const PreparedRegion::Data& region)
        : region_(region), tree_(region.treeAfter(0))
    {
    }

    /// Calls `visit(indices)` with some of the edges that a segment may meet at a time; an edge may
    /// come again.
    template <class Visit>
    void trace(const Segment& s, const SearchGrid& grid, Visit&& visit);
    /// Calls `visit(edge)` with each edge that a segment may meet. One may come again if the
    /// region's grid lists edges in few cells.
    template <class Visit>
    void forEach(const Segment& s, Visit&& visit);
    /// Calls `turn(step, left, right)` with what adds up to the winding numbers on both sides of a
    /// segment just after its start, which is in the region's box. Where no edge is near to the
    /// segment, both are the same: `areAlike`.
    template <class Turn>
    void enter(const SweptLine& swept, const SearchGrid& grid, bool areAlike, Turn&& turn);

private:
    /// Says that cells of a grid listed some edges.
    void count(std::size_t listed, std::size_t cells)
    {
        constexpr std::size_t few = 32;
        if (listed > few * cells)
            tree_ = region_.treeAfter(listed - few * cells);
    }

    const PreparedRegion::Data& region_;
    const EdgeTree* tree_;            ///< null while grids are used
    std::vector<std::size_t> rounds_; ///< for each edge, the last segment it was visited for
    std::size_t round_ = 0;
};

template <class Visit>
void EdgesNear::trace(const Segment& s, const SearchGrid& grid, Visit&& visit)
{
    if (tree_)
        return tree_->trace(s, visit);
    std::size_t listed = 0, cells = 0;
    grid.trace(s, [&](std::size_t first, std::size_t last) {
        const auto edges = grid.edgesIn(first, last);
        listed += edges.size();
        cells += last + 1 - first;
        visit(edges);
    });
    count(listed, cells);
}

template <class Visit>
void EdgesNear::forEach(const Segment& s, Visit&& visit)
{
    // Where edges are listed in few cells, so are those that meet; then it is not worth the room.
    constexpr std::size_t few = 8;
    const std::size_t edges = region_.edges.size();
    if (rounds_.empty() && (tree_ || region_.grid.listed() > few * edges))
        rounds_.assign(edges, 0);
    ++round_;
    trace(s, region_.grid, [&](std::span<const std::uint32_t> near) {
        for (const std::uint32_t i : near)
            if (rounds_.empty() || std::exchange(rounds_[i], round_) != round_)
                visit(region_.edges[i]);
    });
}

template <class Turn>
void EdgesNear::enter(const SweptLine& swept, const SearchGrid& grid, bool areAlike, Turn&& turn)
{
    const BesideStart left{swept.line, 1}, right{swept.line, -1};
    const auto pass = [&](const AreaEdge& edge, const auto& toLeft, const auto& toRight) {
        const int ofLeft = windingStep(edge.segment, toLeft);
        const int ofRight = areAlike ? ofLeft : windingStep(edge.segment, toRight);
        if (ofLeft != 0 || ofRight != 0)
            turn(edge.step, ofLeft, ofRight);
    };
    const auto begin = [&](std::span<const Winding> windings) {
        for (const auto& [step, number] : windings)
            turn(step, number, number);
    };
    if (tree_) {
        const auto [reference, windings] = tree_->anchorNear(swept.segment.a);
        begin(windings);
        const StraightPath toLeft{reference, left}, toRight{reference, right};
        return forEach({reference.at, swept.segment.a},
                       [&](const AreaEdge& edge) { pass(edge, toLeft, toRight); });
    }
    const std::size_t cell = grid.cellOf(swept.segment.a);
    begin(grid.windingsIn(cell));
    const Reference reference = grid.reference(cell);
    const CornerPath toLeft{reference, left}, toRight{reference, right};
    const auto edges = grid.edgesIn(cell, cell);
    for (const std::uint32_t i : edges)
        pass(region_.edges[i], toLeft, toRight);
    count(edges.size(), 1);
}

} // namespace clipping
