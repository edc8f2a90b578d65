// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

class QPainter;

// Areas and strokes of many points, in time that grows with their length: see coverage.h.

namespace app {

/// Paints an object's area by summing, where that takes less time than QPainter does. False:
/// nothing is painted. The painter paints an image.
bool fillSummed(QPainter& painter, const Object& object);

/// The same for its stroke; every pixel gets the ink once, however often the stroke crosses itself.
bool strokeSummed(QPainter& painter, const Object& object);

} // namespace app
