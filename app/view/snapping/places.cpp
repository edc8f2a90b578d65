// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/places.h"

#include "app/base/finite.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int samples = 32, halvings = 50;
constexpr double arcTolerance = 1e-3; // of the radius; the usual quarter of a circle has 0.00027

// u.x * v.y - u.y * v.x with less than two roundings (Kahan).
double preciseCross(const Point& u, const Point& v)
{
    const double product = u.y * v.x;
    return std::fma(u.x, v.y, -product) + std::fma(-u.y, v.x, product);
}

Point pointAt(const clipping::Segment& s, double t)
{
    if (t <= 0)
        return s.a;
    return t >= 1 ? s.b : s.a + (s.b - s.a) * t;
}

Point tangent(const Bezier& c, double t)
{
    const Point a = c.control1 - c.from, b = c.control2 - c.control1, d = c.to - c.control2;
    return (1 - t) * (1 - t) * a + 2 * t * (1 - t) * b + t * t * d;
}

// 0 where the line from `from` to the curve is perpendicular to it.
double slant(const Bezier& c, const Point& from, double t)
{
    return glm::dot(c.at(t) - from, tangent(c, t));
}

double root(const Bezier& c, const Point& from, double low, double high)
{
    const bool rises = slant(c, from, low) < 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = (low + high) / 2;
        (slant(c, from, middle) < 0) == rises ? low = middle : high = middle;
    }
    return (low + high) / 2;
}

} // namespace

Point nearestOn(const clipping::Segment& s, const Point& point)
{
    const Point along = s.b - s.a;
    if (along.x == 0)
        return {s.a.x, std::clamp(point.y, std::min(s.a.y, s.b.y), std::max(s.a.y, s.b.y))};
    if (along.y == 0)
        return {std::clamp(point.x, std::min(s.a.x, s.b.x), std::max(s.a.x, s.b.x)), s.a.y};
    return pointAt(s, glm::dot(point - s.a, along) / glm::dot(along, along));
}

Point nearestOn(const Bezier& curve, const Point& point)
{
    return curve.at(nearestParameter(curve, point, samples));
}

std::optional<Point> footOn(const clipping::Segment& s, const Point& from)
{
    const Point along = s.b - s.a;
    const double t = glm::dot(from - s.a, along) / glm::dot(along, along);
    if (!(t >= 0 && t <= 1))
        return std::nullopt;
    const Point foot = nearestOn(s, from);
    return foot == from ? std::nullopt : std::optional(foot);
}

std::vector<Point> feetOn(const Bezier& curve, const Point& from)
{
    std::vector<Point> feet;
    double before = slant(curve, from, 0);
    for (int i = 0; i < samples; ++i) {
        const double low = double(i) / samples, high = double(i + 1) / samples;
        const double after = slant(curve, from, high);
        if ((before < 0) != (after < 0))
            feet.push_back(curve.at(root(curve, from, low, high)));
        before = after;
    }
    return feet;
}

std::optional<Point> crossing(const clipping::Segment& one, const clipping::Segment& two)
{
    const Point r = one.b - one.a, s = two.b - two.a, between = two.a - one.a;
    const double parallel = preciseCross(r, s);
    const double t = preciseCross(between, s) / parallel, u = preciseCross(between, r) / parallel;
    if (!(t >= 0 && t <= 1 && u >= 0 && u <= 1))
        return std::nullopt;
    Point shared = pointAt(one, t);
    for (int axis = 0; axis < 2; ++axis)
        if (r[axis] == 0)
            shared[axis] = one.a[axis];
        else if (s[axis] == 0)
            shared[axis] = two.a[axis];
    return shared;
}

std::optional<Point> arcCentre(const Bezier& c)
{
    const Point first = tangent(c, 0), last = tangent(c, 1);
    const Point normal(-first.y, first.x);
    // from + normal * t has the same distance from both ends.
    const double scale = glm::dot(last, normal);
    if (scale == 0)
        return std::nullopt; // straight, or a half turn
    const Point centre = c.from + normal * (glm::dot(c.to - c.from, last) / scale);
    const double radius = glm::distance(centre, c.from);
    const auto onCircle = [&](double t) {
        return std::abs(glm::distance(c.at(t), centre) - radius) <= arcTolerance * radius;
    };
    return isFinite(centre) && radius > 0 && onCircle(0.25) && onCircle(0.5) && onCircle(0.75)
                   && onCircle(1)
               ? std::optional(centre)
               : std::nullopt;
}

} // namespace app
