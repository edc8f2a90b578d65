// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/elliptic_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double strays = 5e-4; // of the radius

double cross(const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; }

/// Half of the derivative of the squared distance from p at t, and the derivative of that.
struct Growth {
    Growth(const Bezier& c, const Point& p, double t)
    {
        const Point a = c.control1 - c.from, b = c.control2 - c.control1, d = c.to - c.control2;
        const double s = 1 - t;
        const Point away = c.at(t) - p;
        const Point slope = 3.0 * (s * s * a + 2 * s * t * b + t * t * d);
        value = glm::dot(away, slope);
        change = glm::dot(slope, slope) + glm::dot(away, 6.0 * (s * (b - a) + t * (d - b)));
    }
    double value, change;
};

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

Point onEllipse(const EllipseArc& ellipse, const Point& p)
{
    const auto& [centre, x, y, angle, sweep] = ellipse;
    const double all = cross(x, y);
    const Point way(cross(p - centre, y) / all, cross(x, p - centre) / all);
    const double length = glm::length(way);
    return length > 0 ? centre + (x * way.x + y * way.y) / length : centre + x;
}

double nearestParameter(const Bezier& curve, const Point& p)
{
    constexpr int parts = 8;
    int nearest = 0;
    for (int i = 1; i <= parts; ++i)
        if (glm::distance(curve.at(double(i) / parts), p)
            < glm::distance(curve.at(double(nearest) / parts), p))
            nearest = i;
    double low = double(std::max(nearest - 1, 0)) / parts;
    double high = double(std::min(nearest + 1, parts)) / parts;
    double t = double(nearest) / parts;
    for (double next = t; next >= low && next <= high;) { // Newton's steps, or halves
        t = next;
        const Growth growth(curve, p, t);
        if (t == 0 || t == 1 ? (growth.value >= 0) == (t == 0) : growth.value == 0)
            return t; // an end of the curve may be the nearest point
        (growth.value < 0 ? low : high) = t;
        next = t - growth.value / growth.change;
        if (!(next > low && next < high))
            next = (low + high) / 2;
        if (std::abs(next - t) <= 0x1p-52)
            break;
    }
    return t;
}

} // namespace app
