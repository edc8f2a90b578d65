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
    region_.grid.trace(swept.segment, [&](std::size_t first, std::size_t last) {
        for (const std::uint32_t edge : region_.grid.edgesIn(first, last)) {
            any = true;
            if (const auto meeting = meetingOf(swept, region_.edges[edge]))
                meetings_.add(*meeting);
        }
    });
    return any;
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
