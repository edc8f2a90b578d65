// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app {

/// A cubic Bézier curve with its start point, which a PathSegment takes from its predecessor.
struct Bezier {
    Point from, control1, control2, to;

    /// The point at t, by de Casteljau's algorithm: exact at 0 and 1, and inside the convex hull of
    /// the control points.
    Point at(double t) const;
    Point slope(double t) const; ///< the derivative

    /// The part from t0 to t1 (0 <= t0 <= t1 <= 1) as a separate curve.
    Bezier part(double t0, double t1) const;

    friend bool operator==(const Bezier&, const Bezier&) = default;
};

/// The parameter of the place on a curve that is nearest to a point, beside the best of so many
/// evenly spread ones.
double nearestParameter(const Bezier& curve, const Point& p, int parts = 8);

} // namespace app
