// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"

#include <optional>
#include <vector>

// Places on lines and curves. On horizontal and vertical lines one coordinate is exactly the line's
// own, and the other one exactly that of the given point.

namespace app {

/// The point of a segment that is nearest to `point`.
Point nearestOn(const clipping::Segment& segment, const Point& point);
/// The point of a curve that is nearest to `point`, near the best of 32 evenly spread parameters.
Point nearestOn(const Bezier& curve, const Point& point);

/// The foot of the perpendicular from `from`, if it is on the segment and not `from` itself.
std::optional<Point> footOn(const clipping::Segment& segment, const Point& from);
/// The places where a line from `from` meets the curve at a right angle.
std::vector<Point> feetOn(const Bezier& curve, const Point& from);

/// The point that two segments share; none if they are parallel or not finite. The error is a few
/// ulps of the largest coordinate, divided by the sine of the angle between them.
std::optional<Point> crossing(const clipping::Segment& one, const clipping::Segment& two);

/// The centre of a curve that is a circular arc, to a thousandth of its radius.
std::optional<Point> arcCentre(const Bezier& curve);

} // namespace app
