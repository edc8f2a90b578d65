// SPDX-License-Identifier: MIT
//
// Lines and rays at convex polygons, as `exact` clips segments (exact.cpp): the line enters and
// leaves through two edges that the sides of the corners tell (crossed.h). A ray begins at a,
// unless a is outside the edge of entry; nothing is visible if a is outside that of exit.

#include "clipping/polygon/line_or_ray.h"

#include "clipping/exact/meeting.h"
#include "clipping/ieee_numbers.h"
#include "clipping/polygon/crossed.h"

namespace clipping {
namespace {

/// A new end, and the number of its edge.
struct End {
    glm::dvec2 at;
    std::uint32_t number;
};

/// Where the line crosses edge i. The meeting point is a share of the edge, never of the two points
/// that define the line, because it may be far from these. A corner has the number of the edge that
/// begins there.
End endOn(std::size_t i, const OrientedLine<double>& line, const PolygonIn<double>& polygon)
{
    const std::size_t next = polygon.after(i);
    const Segment edge{polygon.corner(i), polygon.corner(next)};
    if (line.leftOf(edge.a).sign == 0)
        return {edge.a, polygon.number(i)};
    if (line.leftOf(edge.b).sign == 0)
        return {edge.b, polygon.number(next)};
    return {meeting(edge, line.s), polygon.number(i)};
}

/// Whether p comes before q along the line; both are on it.
bool isBefore(const glm::dvec2& p, const glm::dvec2& q, const Segment& line)
{
    const auto& [a, b] = line;
    return a.x != b.x ? (a.x < b.x ? p.x < q.x : q.x < p.x) : a.y < b.y ? p.y < q.y : q.y < p.y;
}

/// At a polygon without area, from one corner to the other, which may be the same.
template <Reach reach>
std::optional<PolygonPiece<double>> inFlat(const OrientedLine<double>& line,
                                           const PolygonIn<double>& polygon)
{
    constexpr bool isRay = reach == Reach::OneWay;
    std::size_t from = 0, to = polygon.size() - 1;
    const auto& [a, b] = line.s;
    const int first = line.leftOf(polygon.corner(from)).sign;
    const int last = line.leftOf(polygon.corner(to)).sign;
    if (first * last > 0)
        return std::nullopt;
    if (first != 0 || last != 0) { // crossed
        if (first < last)
            std::swap(from, to);
        const auto p = polygon.corner(from), q = polygon.corner(to);
        const int side = isRay ? leftOf(p, q, a).sign : -1;
        if (side > 0)
            return std::nullopt;
        const glm::dvec2 at = side == 0 ? a : endOn(0, line, polygon).at;
        return PolygonPiece<double>{{at, at}, side == 0 ? 0 : polygon.number(0), polygon.number(0)};
    }
    if (isBefore(polygon.corner(to), polygon.corner(from), line.s))
        std::swap(from, to);
    PolygonPiece<double> piece{
        {polygon.corner(from), polygon.corner(to)}, polygon.number(from), polygon.number(to)};
    if (isRay && !isBefore(a, piece.segment.a, line.s))
        piece.segment.a = a, piece.numberOfA = 0;
    if (isBefore(piece.segment.b, piece.segment.a, line.s))
        return std::nullopt;
    return piece;
}

} // namespace

template <Reach reach>
std::optional<PolygonPiece<double>> lineOrRayInPolygon(const Segment& through,
                                                       const PreparedPolygon& prepared)
{
    if (!legal(through) || through.a == through.b)
        return std::nullopt;
    const PolygonIn<double> polygon(prepared);
    const OrientedLine<double> line(through);
    if (prepared.flat)
        return inFlat<reach>(line, polygon);
    const auto crossed = Searched::crossed(line, polygon);
    if (!crossed)
        return std::nullopt;
    const auto [enter, leave] = *crossed;
    PolygonPiece<double> piece{through};
    if (reach == Reach::BothWays || sideOf(through.a, enter, polygon) < 0) {
        const End end = endOn(enter, line, polygon);
        piece.segment.a = end.at, piece.numberOfA = end.number;
    }
    const int aLeaves = reach == Reach::BothWays ? 1 : sideOf(through.a, leave, polygon);
    if (aLeaves < 0)
        return std::nullopt;
    const End end = endOn(leave, line, polygon);
    piece.segment.b = aLeaves == 0 ? through.a : end.at, piece.numberOfB = end.number;
    if (reach == Reach::OneWay && piece.segment.a == through.a)
        piece.numberOfA = 0; // rounded back to a
    return piece;
}

template std::optional<PolygonPiece<double>>
lineOrRayInPolygon<Reach::OneWay>(const Segment&, const PreparedPolygon&);
template std::optional<PolygonPiece<double>>
lineOrRayInPolygon<Reach::BothWays>(const Segment&, const PreparedPolygon&);

} // namespace clipping
