// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/elliptic_curve.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double strays = 5e-4; // of the radius

/// The way from the centre, where the axes are those of the plane.
Point wayFromCentre(const EllipseArc& ellipse, const Point& p)
{
    const auto& [centre, x, y, angle, sweep] = ellipse;
    const double all = cross(x, y);
    return {cross(p - centre, y) / all, cross(x, p - centre) / all};
}

bool isOn(const EllipseArc& ellipse, const Point& p)
{
    const Point there = onEllipse(ellipse, p);
    return glm::distance(there, p) <= strays * glm::distance(there, ellipse.centre);
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
