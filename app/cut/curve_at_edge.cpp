// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curve_at_edge.h"

namespace app {
namespace {

bool isLeftOf(const clipping::Segment& line, const Point& p)
{
    return cross(line.b - line.a, p - line.a) > 0;
}

} // namespace

bool isCurve(const Subpath& path, std::size_t segment)
{
    return segment < path.segments.size() && path.segments[segment].curved;
}

Bezier curveOf(const Subpath& path, std::size_t segment)
{
    const PathSegment& s = path.segments[segment];
    return {segment == 0 ? path.start : path.segments[segment - 1].to, s.control1, s.control2,
            s.to};
}

std::optional<CurvePoint> crossing(const Bezier& curve, const Chord& chord,
                                   const clipping::Segment& edge)
{
    const auto t = passage(curve, chord, [&](const Point& p) { return isLeftOf(edge, p); });
    if (!t)
        return std::nullopt;
    CurvePoint found{*t, curve.at(*t)};
    for (const int axis : {0, 1})
        if (edge.a[axis] == edge.b[axis])
            found.point[axis] = edge.a[axis];
    return found;
}

} // namespace app
