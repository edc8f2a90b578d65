// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/border_curve.h"

#include "app/document/elliptic_curve.h"

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

} // namespace app
