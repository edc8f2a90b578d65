// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

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
