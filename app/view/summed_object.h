// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

class QPainter;

// Fills and strokes with many points, in time that grows with their length: see coverage.h.

namespace app {

/// Fills an object by summation if this takes less time than QPainter. Returns false if nothing was
/// painted. The painter must paint on an image.
bool fillSummed(QPainter& painter, const Object& object);

/// The same for its stroke. Every pixel is painted once, however often the stroke crosses itself.
bool strokeSummed(QPainter& painter, const Object& object);

} // namespace app
