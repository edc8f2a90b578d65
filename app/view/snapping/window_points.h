// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/window_shape.h"
#include "app/view/snapping/own_points.h"

namespace app {

/// The places by which a clip window snaps that is moved: the corners of a rectangle, also of a
/// rotated one, with the middles of its sides and its centre; the centre and the outermost points
/// of an ellipse; the corners of a path of straight edges. Other paths snap by their box.
OwnPoints ownPointsOf(const WindowShape& shape);

} // namespace app
