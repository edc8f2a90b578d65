// SPDX-License-Identifier: MIT
#include "clipping/region/sweep.h"

#include "clipping/ieee_numbers.h"

namespace clipping {

std::span<const RegionPiece> LineSweep::piecesOf(const Segment& segment, std::uint32_t source,
                                                 const RegionGrid& grid)
{
    const SweptLine swept(segment);
    findMeetings(swept, grid);
    meetings_.sort(swept);
    enterAt(swept, grid);
    return walk_.piecesOf(swept, meetings_, source);
}

void LineSweep::findMeetings(const SweptLine& swept, const RegionGrid& grid)
{
    std::size_t count = 0;
    edges_.trace(swept.segment, grid, [&](std::span<const std::uint32_t> edges) {
        count = addNear(swept.line, edges, count);
    });
    meetings_.clear();
    isNearEdge_ = false;
    for (const std::uint32_t i : std::span(near_).first(count)) {
        if (swept.isApartFrom(region_.edges[i].segment))
            continue;
        isNearEdge_ = true;
        if (const auto meeting = meetingOf(swept, region_.edges[i]))
            meetings_.add(*meeting);
    }
}

/// Adds the edges that the line may meet to the first `count` ones in `near_`; returns their
/// number.
std::size_t LineSweep::addNear(const DirectedLine& line, std::span<const std::uint32_t> edges,
                               std::size_t count)
{
    if (near_.size() < count + edges.size())
        near_.resize(2 * (count + edges.size()));
    for (const std::uint32_t edge : edges) {
        near_[count] = edge;
        count += !line.certainlyMisses(region_.edges[edge].segment);
    }
    return count;
}

/// Counts the windings beside the start of the segment.
void LineSweep::enterAt(const SweptLine& swept, const RegionGrid& grid)
{
    if (contains(grid.box(), swept.segment.a))
        // No edge passes between both sides of a start that none is near.
        edges_.enter(swept, grid, !isNearEdge_, [&](std::uint32_t step, int left, int right) {
            walk_.turn(step, left, right);
        });
}

} // namespace clipping
