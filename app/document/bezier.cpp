// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/bezier.h"

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

} // namespace

Point Bezier::at(double t) const { return blossom(*this, t, t, t); }

Bezier Bezier::part(double t0, double t1) const
{
    return {at(t0), blossom(*this, t0, t0, t1), blossom(*this, t0, t1, t1), at(t1)};
}

} // namespace app
