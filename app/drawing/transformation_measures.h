// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/transformation.h"

namespace app {

constexpr double mostSkew = 89; ///< degrees

/// Length and angle of the way; along an axis, only the way on it.
const GestureMeasure& moveMeasure(Along axis);
/// The angle about the pivot from where the pointer was to where it is.
const GestureMeasure& rotationMeasure(Along axis);
/// The pointer's distance from the pivot, divided by that at the start; negative on the other side.
const GestureMeasure& scalingMeasure(Along axis);
/// The angle by which the lines across the axis lean, below 90°.
const GestureMeasure& skewMeasure(Along axis);

} // namespace app
