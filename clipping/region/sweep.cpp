// SPDX-License-Identifier: MIT
#include "clipping/region/sweep.h"

#include "clipping/ieee_numbers.h"

namespace clipping {

std::span<const RegionPiece> LineSweep::piecesOf(const Segment& segment, std::uint32_t source)
{
    const SweptLine swept(segment);
    if (findMeetings(swept)) {
        meetings_.sort(swept);
        enterAt(swept);
        return walk_.piecesOf(swept, meetings_, source);
    }
    whole_ = {segment, source, 0, 0};
    return {&whole_, keepsStart(segment) ? 1U : 0U};
}

/// Whether a segment is kept that no edge is near.
bool LineSweep::keepsStart(const Segment& segment) const
{
    return contains(region_.grid.box(), segment.a)
               ? region_.keepsReference[region_.grid.cellOf(segment.a)] != 0
               : region_.keepsNone;
}

/// Whether there may be an edge between the segment and the reference point of its start.
bool LineSweep::findMeetings(const SweptLine& swept)
{
    meetings_.clear();
    bool any = false;
    std::size_t count = 0;
    region_.grid.trace(swept.segment, [&](std::size_t first, std::size_t last) {
        const auto edges = region_.grid.edgesIn(first, last);
        if (edges.empty())
            return;
        any = true;
        count = addNear(swept.line, edges, count);
    });
    for (const std::uint32_t edge : std::span(near_).first(count))
        if (const auto meeting = meetingOf(swept, region_.edges[edge]))
            meetings_.add(*meeting);
    return any;
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
void LineSweep::enterAt(const SweptLine& swept)
{
    const SearchGrid& grid = region_.grid;
    if (!contains(grid.box(), swept.segment.a))
        return;
    const std::size_t cell = grid.cellOf(swept.segment.a);
    for (const auto& [step, winding] : grid.windingsIn(cell))
        walk_.turn(step, winding, winding);
    const Reference reference = grid.reference(cell);
    const BesideStart left{swept.line, 1}, right{swept.line, -1};
    for (const std::uint32_t i : grid.edgesIn(cell, cell)) {
        const AreaEdge& edge = region_.edges[i];
        const int ofLeft = windingStep(edge.segment, reference, left);
        const int ofRight = windingStep(edge.segment, reference, right);
        if (ofLeft != 0 || ofRight != 0)
            walk_.turn(edge.step, ofLeft, ofRight);
    }
}

} // namespace clipping
