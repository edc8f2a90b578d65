// SPDX-License-Identifier: MIT
//
// Winding number, for areas of any shape: O(N) for each segment. Far behind the segment the winding
// number of every area is 0. Orientation tests of each edge's ends against the line tell whether
// the line crosses the edge. What it crosses behind the segment's start or there is added to the
// number at the start; what it crosses on the segment is ordered (exact/order_on_line.h) and passed
// in that order (line_walk.h). Corners on the line and edges along it need no rule, as the numbers
// are counted on both sides of the line, infinitely near.

#include "clipping/region/winding_number.h"

#include "clipping/frame.h"
#include "clipping/ieee_numbers.h"
#include "clipping/region/line_walk.h"
#include "clipping/region/resume.h"

namespace clipping {
namespace {

class WindingPieces {
public:
    explicit WindingPieces(const PreparedRegion::Data& region) : region_(region), walk_(region) {}

    std::span<const RegionPiece> of(const Segment& segment, std::uint32_t source)
    {
        if (!legal(segment)) { // it is in no area
            whole_ = {segment, source, 0, 0};
            return {&whole_, region_.keepsNone ? 1U : 0U};
        }
        const SweptLine swept(segment);
        testEdges(swept);
        meetings_.sort(swept);
        return walk_.piecesOf(swept, meetings_, source);
    }

private:
    void testEdges(const SweptLine& swept);
    static bool isBehind(const SweptLine& swept, const Meeting& crossing);

    const PreparedRegion::Data& region_;
    LineWalk walk_;
    Meetings meetings_;
    RegionPiece whole_{};
};

void WindingPieces::testEdges(const SweptLine& swept)
{
    meetings_.clear();
    glm::dvec2 last{};
    int sideOfLast = 0;
    bool isFirst = true;
    for (const AreaEdge& edge : region_.edges) {
        const auto& [from, to] = edge.segment;
        // Most edges begin where the one before ends.
        const int sideOfFrom = !isFirst && from == last ? sideOfLast : swept.line.side(from);
        const int sideOfTo = swept.line.side(to);
        last = to, sideOfLast = sideOfTo, isFirst = false;
        if (sideOfFrom == sideOfTo)
            continue;
        const auto meeting = meetingOf(swept, edge, sideOfFrom, sideOfTo);
        if (meeting)
            meetings_.add(*meeting);
        const Meeting crossing = meeting ? *meeting : crossingOf(edge, sideOfFrom, sideOfTo);
        if (meeting ? meeting->place == Meeting::Place::Start : isBehind(swept, crossing))
            walk_.turn(edge.step, crossing.left(), crossing.right());
    }
}

/// Whether an edge that the line crosses off the segment is behind it.
bool WindingPieces::isBehind(const SweptLine& swept, const Meeting& crossing)
{
    const auto& [from, to] = crossing.edge->segment;
    const glm::dvec2& start = swept.segment.a;
    if (crossing.atVertex())
        return orderOfVertices(swept.line, crossing.vertex(), start) < 0;
    // An edge to the line's left has what is ahead of it on its right.
    return leftOf(from, to, start).sign == -crossing.sideOfTo;
}

} // namespace

RegionProgress windingClipAll(std::span<const Segment> in, const PreparedRegion& region,
                              std::span<RegionPiece> out, RegionProgress from)
{
    WindingPieces pieces(region.data());
    return clipEach(in, pieces, out, from);
}

std::vector<RegionPiece> windingClip(const Segment& segment, const PreparedRegion& region)
{
    WindingPieces pieces(region.data());
    return piecesOf(segment, pieces);
}

} // namespace clipping
