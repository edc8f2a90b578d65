// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"

#include <optional>

namespace app {

/// A curve, and the directions (unit vectors) of its ends, which a neighbour may share.
struct DirectedCurve {
    Bezier curve;
    Point direction0, direction1;
};

/// The unit vector at the left of a direction, if y points down at the right.
inline Point normalOf(const Point& direction) { return {-direction.y, direction.x}; }

/// The curve beside another one at a distance, on the side of the normals (at the other side if it
/// is negative).
struct OffsetCurve {
    Bezier curve;
    /// Beyond the centre of curvature: the curve runs backwards, and the lines to it cross.
    bool isReversed = false;
};

/// An approximation by one cubic curve: off by at most `tolerance`. Empty if there is none, because
/// the curve turns by more than a quarter, or because the distance is that of its centre of
/// curvature somewhere: its halves may have one.
std::optional<OffsetCurve> offsetCurve(const DirectedCurve& of, double distance, double tolerance);

} // namespace app
