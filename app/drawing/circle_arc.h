// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/drawing/gesture_measure.h"

#include <optional>

// Arcs of circles, as people draw them. Angles are in degrees, counterclockwise on screen.

namespace app {

struct CircleArc {
    Point centre, from, to;
    double degrees = 0; ///< from `from` to `to`, in [−360, 360]; ±360: the whole circle
};

/// The arc through three points; empty if they lie on a line, or two of them on one spot.
std::optional<CircleArc> arcThrough(const Point& from, const Point& to, const Point& on);

/// The arc of this angle between two points; between −360 and 360, but not 0.
CircleArc arcOfAngle(const Point& from, const Point& to, double degrees);

CircleArc arcAround(const Point& centre, const Point& from, double degrees);

double radiusOf(const CircleArc& arc);
Point middleOf(const CircleArc& arc);

/// Begins and ends in the arc's points, bit for bit.
Subpath pathOf(const CircleArc& arc);

} // namespace app

// How the last point of an arc is measured.

namespace app {

/// Through three points: radius and angle of the arc from `from` to `pointer`. One of them decides
/// the other; the pointer decides the side and, with a radius, which of the two arcs. A negative
/// angle goes to the other side.
const GestureMeasure& arcMeasure();

/// On which way around.
enum class Turn : std::uint8_t { Counterclockwise, Clockwise };

/// By its centre `from`: the angle of the arc that begins at `pointer`, positive counterclockwise.
/// The pointer goes that way around; a typed angle goes the way of its sign.
const GestureMeasure& sweepMeasure(Turn turn);

} // namespace app
