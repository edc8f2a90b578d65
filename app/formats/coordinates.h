// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <string>

namespace app {

/// Appends a point of the drawing, x and y with `between` between them, with the decimals that
/// `options` ask for and then inside their bounds.
void appendPoint(std::string& text, const Point& point, char between, const WriteOptions& options);

/// One coordinate of a point: of x (axis 0) or y (axis 1).
void appendCoordinate(std::string& text, double value, int axis, const WriteOptions& options);

/// The same as appendPoint for a control point of a curve, which no bounds hold: the curve's own
/// points are inside when its controls are not.
void appendControl(std::string& text, const Point& point, char between,
                   const WriteOptions& options);

} // namespace app
