// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app {

/// A cubic Bézier curve with its first point, which a PathSegment leaves to its predecessor.
struct Bezier {
    Point from, control1, control2, to;

    /// The point at t, by repeated interpolation: exact at 0 and 1, and inside the convex hull.
    Point at(double t) const;

    /// The part from t0 to t1 (0 <= t0 <= t1 <= 1), as a curve of its own.
    Bezier part(double t0, double t1) const;
};

} // namespace app
