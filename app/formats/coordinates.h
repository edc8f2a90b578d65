// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "clipping/geometry.h"

#include <QString>

#include <string>

namespace app {

/// Appends a point of the drawing, with the character `between` between x and y. The number of
/// decimals and the bounds are those of `options`.
void appendPoint(std::string& text, const Point& point, char between, const WriteOptions& options);

/// Appends one coordinate of a point: x (axis 0) or y (axis 1).
void appendCoordinate(std::string& text, double value, int axis, const WriteOptions& options);

/// Like appendPoint, for a control point of a curve. The bounds do not apply: a curve may lie
/// inside them although its control points do not.
void appendControl(std::string& text, const Point& point, char between,
                   const WriteOptions& options);

/// Whether the ends of a line with a length are written alike, because of limited decimals.
bool becomesPoint(const clipping::Segment& line, const WriteOptions& options);

/// The point that is written.
Point roundedPoint(const Point& point, const WriteOptions& options);
Point roundedControl(const Point& point, const WriteOptions& options); ///< of a curve

/// "-100,-75,100,75": xmin, ymin, xmax and ymax as the command line accepts them. The numbers must
/// be finite, and read back bit for bit.
QString rectangleText(const clipping::Window& rectangle);

} // namespace app
