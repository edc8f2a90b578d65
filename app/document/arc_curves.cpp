// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/arc_curves.h"

#include <glm/geometric.hpp>

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

namespace {

constexpr double strays = 5e-4; // of the radius, for a quarter turn

/// The way from the centre, where the axes are those of the plane.
Point wayFromCentre(const EllipseArc& ellipse, const Point& p)
{
    const auto& [centre, x, y, angle, sweep] = ellipse;
    const double all = cross(x, y);
    return {cross(p - centre, y) / all, cross(x, p - centre) / all};
}

// A flat curve that is drawn freely is near to an ellipse, too: the flatter, the nearer it must be.
bool isOn(const EllipseArc& ellipse, const Point& p)
{
    const Point there = onEllipse(ellipse, p);
    const double most = strays * std::pow(ellipse.sweep / quarterTurn, 3);
    return glm::distance(there, p) <= most * glm::distance(there, ellipse.centre);
}

} // namespace

// Where the tangents at both ends meet, an affine map takes the curve to the usual one for a part
// of the unit circle. With u = tan(angle / 4), its control points are at 2/3 (1 - u²) of the way
// from the ends to where the tangents meet.
std::optional<EllipseArc> ellipseOf(const Bezier& curve)
{
    const Point first = curve.control1 - curve.from, last = curve.control2 - curve.to;
    const Point chord = curve.to - curve.from;
    const double turn = cross(first, last);
    const double a = cross(chord, last) / turn, b = cross(chord, first) / turn;
    if (!(a > 1.5 && a < 2 && std::abs(a - b) < 0.01)) // 1.5: no turn; 2: more than a quarter
        return std::nullopt;
    const double square = 1 - 3 / (a + b); // of u
    const double half = 2 * std::atan(std::sqrt(square));
    if (!(half > std::numbers::pi / 64))
        return std::nullopt;
    const double c = std::cos(half), s = std::sin(half);
    const Point middle = (curve.from + curve.to) * 0.5;
    const Point corner = (curve.from + a * first + curve.to + b * last) * 0.5;
    const Point centre = middle + (middle - corner) * (c * c / (s * s));
    const EllipseArc ellipse{centre, (middle - centre) / c, chord / (2 * s), -half, 2 * half};
    for (const double t : {0.2, 0.35, 0.5, 0.65, 0.8})
        if (!isOn(ellipse, curve.at(t)))
            return std::nullopt;
    return ellipse;
}

double angleTowards(const EllipseArc& ellipse, const Point& p)
{
    const Point way = wayFromCentre(ellipse, p);
    return std::atan2(way.y, way.x);
}

Point onEllipse(const EllipseArc& ellipse, const Point& p)
{
    const auto& [centre, x, y, angle, sweep] = ellipse;
    const Point way = wayFromCentre(ellipse, p);
    const double length = glm::length(way);
    return length > 0 ? centre + (x * way.x + y * way.y) / length : centre + x;
}

} // namespace app
