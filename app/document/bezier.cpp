// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bezier.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

Point between(const Point& p, const Point& q, double t) { return (1 - t) * p + t * q; }

// The blossom (polar form) of the curve. The control points of the part [t0, t1] are its values at
// (t0 t0 t0), (t0 t0 t1), (t0 t1 t1) and (t1 t1 t1).
Point blossom(const Bezier& c, double r, double s, double t)
{
    const Point a = between(c.from, c.control1, r);
    const Point b = between(c.control1, c.control2, r);
    const Point d = between(c.control2, c.to, r);
    return between(between(a, b, s), between(b, d, s), t);
}

/// Half of the derivative of the squared distance from p at t, and the derivative of that.
struct Growth {
    Growth(const Bezier& c, const Point& p, double t)
    {
        const Point a = c.control1 - c.from, b = c.control2 - c.control1, d = c.to - c.control2;
        const double s = 1 - t;
        const Point away = c.at(t) - p;
        const Point slope = c.slope(t);
        value = glm::dot(away, slope);
        change = glm::dot(slope, slope) + glm::dot(away, 6.0 * (s * (b - a) + t * (d - b)));
    }
    double value, change;
};

} // namespace

Point Bezier::at(double t) const { return blossom(*this, t, t, t); }

Point Bezier::slope(double t) const
{
    const double s = 1 - t;
    return 3.0
           * (s * s * (control1 - from) + 2 * s * t * (control2 - control1)
              + t * t * (to - control2));
}

Bezier Bezier::part(double t0, double t1) const
{
    return {at(t0), blossom(*this, t0, t0, t1), blossom(*this, t0, t1, t1), at(t1)};
}

double nearestParameter(const Bezier& curve, const Point& p, int parts)
{
    int nearest = 0;
    double least = glm::distance(curve.from, p);
    for (int i = 1; i <= parts; ++i)
        if (const double away = glm::distance(curve.at(double(i) / parts), p); away < least)
            least = away, nearest = i;
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
