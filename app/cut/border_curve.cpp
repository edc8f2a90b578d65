// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/border_curve.h"

#include "app/document/arc_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

Point BorderCurve::at(double t) const { return bezier ? bezier->at(t) : ellipse.at(t); }

Point BorderCurve::slope(double t) const { return bezier ? bezier->slope(t) : ellipse.slope(t); }

double BorderCurve::near(const Point& p, double other) const
{
    if (bezier)
        return nearestParameter(*bezier, p);
    return other + std::remainder(angleTowards(ellipse, p) - other, 2 * std::numbers::pi);
}

void BorderCurve::append(std::vector<PathSegment>& segments, double from, double to,
                         const Point& start, const Point& end) const
{
    if (!bezier) {
        const auto& [centre, axis1, axis2, angle, sweep] = ellipse;
        return appendCurves(segments, {centre, axis1, axis2, from, to - from}, start, end);
    }
    const Bezier part = bezier->part(std::min(from, to), std::max(from, to));
    segments.push_back(from < to ? PathSegment{end, part.control1, part.control2, true}
                                 : PathSegment{end, part.control2, part.control1, true});
}

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
