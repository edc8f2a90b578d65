// SPDX-License-Identifier: MIT
#include "clipping/region/meeting.h"

#include "clipping/exact/meeting.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>

namespace clipping {
namespace {

using Place = Meeting::Place;

/// For an edge with one end on the line.
std::optional<Meeting> meetingAtVertex(const SweptLine& swept, Meeting meeting)
{
    const glm::dvec2& p = meeting.vertex();
    const Segment& s = swept.segment;
    if (!swept.has(p))
        return std::nullopt;
    if (p == s.a)
        meeting.place = Place::Start;
    else if (p == s.b)
        meeting.place = Place::End;
    return meeting;
}

/// For an edge whose ends are on both sides of the line.
std::optional<Meeting> meetingAcross(const Segment& s, Meeting meeting)
{
    const Segment& edge = meeting.edge->segment;
    const auto start = boundedLeftOf(edge.a, edge.b, s.a);
    const auto end = s.a == s.b ? start : boundedLeftOf(edge.a, edge.b, s.b);
    if (start.sign == 0)
        meeting.place = Place::Start;
    else if (end.sign == 0)
        meeting.place = Place::End;
    else if (start.sign == end.sign)
        return std::nullopt;
    meeting.sideOfStart = static_cast<std::int8_t>(start.sign);
    meeting.share = shareAt(start, end);
    return meeting;
}

std::strong_ordering reversed(std::strong_ordering order)
{
    return std::is_lt(order)   ? std::strong_ordering::greater
           : std::is_gt(order) ? std::strong_ordering::less
                               : order;
}

/// The order of a vertex on the line and a crossing.
std::strong_ordering orderOfVertex(const glm::dvec2& vertex, const Meeting& crossing)
{
    const Segment& edge = crossing.edge->segment;
    const int side = leftOf(edge.a, edge.b, vertex).sign;
    if (side == 0)
        return std::strong_ordering::equal;
    return side == crossing.sideOfStart ? std::strong_ordering::less
                                        : std::strong_ordering::greater;
}

} // namespace

std::strong_ordering orderOfVertices(const DirectedLine& line, const glm::dvec2& p,
                                     const glm::dvec2& q)
{
    if (const int x = line.signX(); x != 0)
        return x * signOf(q.x, p.x) <=> 0;
    return line.signY() * signOf(q.y, p.y) <=> 0;
}

std::optional<Meeting> meetingOf(const SweptLine& swept, const AreaEdge& edge, int sideOfFrom,
                                 int sideOfTo)
{
    const Meeting meeting = crossingOf(edge, sideOfFrom, sideOfTo);
    return meeting.atVertex() ? meetingAtVertex(swept, meeting)
                              : meetingAcross(swept.segment, meeting);
}

std::strong_ordering order(const SweptLine& swept, const Meeting& p, const Meeting& q)
{
    if (p.atVertex() && q.atVertex())
        return orderOfVertices(swept.line, p.vertex(), q.vertex());
    if (p.atVertex())
        return orderOfVertex(p.vertex(), q);
    if (q.atVertex())
        return reversed(orderOfVertex(q.vertex(), p));
    return orderOnLine(swept.segment, {p.edge->segment, p.share}, {q.edge->segment, q.share});
}

glm::dvec2 pointOf(const SweptLine& swept, const Meeting& meeting)
{
    if (meeting.atVertex())
        return {meeting.vertex().x + 0.0, meeting.vertex().y + 0.0}; // never -0
    return clipping::meeting<double>(swept.segment, meeting.edge->segment);
}

std::vector<Spoke> spokesOn(int side, std::span<const Meeting> meetings)
{
    std::vector<Spoke> spokes;
    for (const Meeting& meeting : meetings) {
        // Left of an edge the winding number is greater by 1. To the left of the line, going from
        // front to back is going counter-clockwise, hence from the right of an edge that points
        // away to its left.
        const auto& [from, to] = meeting.edge->segment;
        if (meeting.sideOfTo == side)
            spokes.push_back({from, to, side});
        if (meeting.sideOfFrom == side)
            spokes.push_back({to, from, -side});
    }
    std::ranges::sort(spokes, [side](const Spoke& p, const Spoke& q) {
        return cross(p.to - p.from, p.from, p.to, q.from, q.to).sign * side > 0;
    });
    return spokes;
}

} // namespace clipping
