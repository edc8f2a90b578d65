// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/gesture_measure.h"

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
