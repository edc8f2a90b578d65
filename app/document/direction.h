// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

// Angles as people read them: degrees, counterclockwise from the right, although y grows down (as
// in Illustrator, Figma and AutoCAD).

namespace app {

/// The unit vector of an angle; exact for multiples of 30° where a coordinate is 0, ½ or 1.
Point directionOf(double degrees);

/// The angle of a vector, in (−180, 180]; 0 for the zero vector.
double degreesOf(const Point& vector);

/// `to`, rotated about `from` so that the angle is a multiple of 15°.
Point turnedToStep(const Point& from, const Point& to);

} // namespace app
