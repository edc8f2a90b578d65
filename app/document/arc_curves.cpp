// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/arc_curves.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;

/// How far control points reach along the tangents of an arc with the radius 1.
double reachOf(double sweep) { return 4.0 / 3 * std::tan(sweep / 4); }

} // namespace

Point EllipseArc::at(double t) const { return centre + axis1 * std::cos(t) + axis2 * std::sin(t); }

Point EllipseArc::slope(double t) const { return axis2 * std::cos(t) - axis1 * std::sin(t); }

void appendCurves(std::vector<PathSegment>& segments, const EllipseArc& arc, const Point& from,
                  const Point& to)
{
    const int count = std::max(1, int(std::ceil(std::abs(arc.sweep) / quarterTurn - 1e-9)));
    const double step = arc.sweep / count, reach = reachOf(step);
    Point last = from;
    for (int i = 0; i < count; ++i) {
        const double t0 = arc.angle + i * step, t1 = t0 + step;
        const Point end = i + 1 == count ? to : arc.at(t1);
        segments.push_back({end, last + reach * arc.slope(t0), end - reach * arc.slope(t1), true});
        last = end;
    }
}

Subpath roundedRectangle(const Point& min, const Point& max, const Point& radii)
{
    const auto [rx, ry] = std::pair(radii.x, radii.y);
    const double reach = reachOf(quarterTurn);
    Subpath path{{min.x + rx, min.y}, {}, true};
    Point at = path.start;
    const auto side = [&](const Point& end, const Point& corner, const Point& to) {
        if (end != at)
            path.segments.push_back({end});
        path.segments.push_back(
            {to, end + (corner - end) * reach, to + (corner - to) * reach, true});
        at = to;
    };
    side({max.x - rx, min.y}, {max.x, min.y}, {max.x, min.y + ry});
    side({max.x, max.y - ry}, max, {max.x - rx, max.y});
    side({min.x + rx, max.y}, {min.x, max.y}, {min.x, max.y - ry});
    side({min.x, min.y + ry}, min, path.start);
    return path;
}

} // namespace app
