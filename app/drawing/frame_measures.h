// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/gesture_measure.h"

// Width and height of a rectangle that is rotated. GestureStart::from is the point that stays,
// GestureStart::pointer any other point in the direction of the width.

namespace app {

const GestureMeasure& rotatedWidthAndHeight(Anchor anchor);
/// For a side that is dragged; `axis` 0: the width, 1: the height.
const GestureMeasure& rotatedSideLength(int axis, Anchor anchor);

} // namespace app
