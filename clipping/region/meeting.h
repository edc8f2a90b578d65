// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/order_on_line.h"
#include "clipping/region/beside.h"
#include "clipping/region/edges.h"

#include <glm/common.hpp>

#include <optional>

namespace clipping {

/// A segment and the line through it. A segment that is a point has a horizontal line.
struct SweptLine {
    explicit SweptLine(const Segment& s)
        : segment(s),
          line(s.a == s.b ? DirectedLine{s.a, {0, 0}, {1, 0}} : DirectedLine{s.a, s.a, s.b}),
          box{glm::min(s.a, s.b), glm::max(s.a, s.b)}
    {
    }
    bool has(const glm::dvec2& p) const ///< for a point on the line
    {
        return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
    }
    /// Whether the edge certainly has no common point with the segment.
    bool isApartFrom(const Segment& edge) const
    {
        const glm::dvec2 &p = edge.a, &q = edge.b;
        return (p.x < box.min.x && q.x < box.min.x) || (p.x > box.max.x && q.x > box.max.x)
               || (p.y < box.min.y && q.y < box.min.y) || (p.y > box.max.y && q.y > box.max.y);
    }
    Segment segment;
    DirectedLine line;
    Window box; ///< the segment's bounding box
};

/// The single point that a segment and an edge have in common; an edge along the segment's line has
/// no meeting. Whoever passes it to the left of the line sees the winding number change by `left`,
/// whoever passes it to the right by `right`.
struct Meeting {
    enum class Place : std::uint8_t { Start, Between, End };

    const AreaEdge* edge;
    std::int8_t sideOfFrom, sideOfTo; ///< of the edge's ends, relative to the line
    Place place;                      ///< on the segment
    std::int8_t sideOfStart;          ///< of the segment's start, relative to the edge
    Share share;                      ///< if neither of the edge's ends is the common point

    int left() const { return (sideOfFrom > 0) - (sideOfTo > 0); }
    int right() const { return (sideOfTo < 0) - (sideOfFrom < 0); }

    bool atVertex() const { return sideOfFrom == 0 || sideOfTo == 0; }
    const glm::dvec2& vertex() const { return sideOfFrom == 0 ? edge->segment.a : edge->segment.b; }
};

/// The crossing of a line and an edge whose ends are on different sides of it, not yet placed.
inline Meeting crossingOf(const AreaEdge& edge, int sideOfFrom, int sideOfTo)
{
    return {&edge,
            static_cast<std::int8_t>(sideOfFrom),
            static_cast<std::int8_t>(sideOfTo),
            Meeting::Place::Between,
            0,
            {}};
}

/// The meeting of a segment and an edge whose ends are on different sides of the line, if any.
std::optional<Meeting> meetingOf(const SweptLine& swept, const AreaEdge& edge, int sideOfFrom,
                                 int sideOfTo);

/// The meeting of a segment and an edge, if any.
inline std::optional<Meeting> meetingOf(const SweptLine& swept, const AreaEdge& edge)
{
    if (swept.isApartFrom(edge.segment))
        return std::nullopt;
    const int from = swept.line.side(edge.segment.a), to = swept.line.side(edge.segment.b);
    return from == to ? std::nullopt : meetingOf(swept, edge, from, to);
}

/// The order of two points on the line along it.
std::strong_ordering orderOfVertices(const DirectedLine& line, const glm::dvec2& p,
                                     const glm::dvec2& q);

/// The order of two meetings along the segment, which is not a point.
std::strong_ordering order(const SweptLine& swept, const Meeting& p, const Meeting& q);

/// The common point: each coordinate of the exact one, rounded once; never -0.
glm::dvec2 pointOf(const SweptLine& swept, const Meeting& meeting);

/// Whether a point is in an area: whether one of the faces around it is filled. `meetings` are
/// those of the area's edges with the segment at that point, `left` and `right` the winding numbers
/// beside the line just after it. `fills` answers for a winding number.
template <class Fills>
bool isFilledAround(std::span<const Meeting> meetings, int left, int right, Fills fills);

/// An edge's part on one side of the line, as seen from the meeting.
struct Spoke {
    glm::dvec2 from, to; ///< its direction
    int change;          ///< of the winding number where it is crossed from front to back
};

/// The spokes on one side of the line (1 for left, -1 for right), from front to back.
std::vector<Spoke> spokesOn(int side, std::span<const Meeting> meetings);

template <class Fills>
bool isFilledAround(std::span<const Meeting> meetings, int left, int right, Fills fills)
{
    for (const int side : {1, -1}) {
        int winding = side > 0 ? left : right;
        if (fills(winding))
            return true;
        const auto spokes = spokesOn(side, meetings);
        for (std::size_t i = 0; i < spokes.size(); ++i) {
            winding += spokes[i].change;
            const bool isLast = i + 1 == spokes.size()
                                || cross(spokes[i].to - spokes[i].from, spokes[i].from,
                                         spokes[i].to, spokes[i + 1].from, spokes[i + 1].to)
                                           .sign
                                       != 0;
            if (isLast && fills(winding)) // there is a face behind the spoke
                return true;
        }
    }
    return false;
}

} // namespace clipping
