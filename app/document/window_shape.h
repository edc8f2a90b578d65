// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/clip_windows.h"

#include <optional>

namespace app {

// The shape of a clip window as something that is moved, resized and rotated.

/// The rectangle that a shape's handles stand on, rotated by `angle` (radians, from x towards y)
/// about its centre. A rectangle's own; of a path its bounding box, never rotated.
using WindowFrame = RectangleShape;
WindowFrame frameOf(const WindowShape& shape);

/// Whether it is a path without points.
bool isEmpty(const WindowShape& shape);
/// The bounding box along the axes; of an empty path the origin.
clipping::Window boxOf(const WindowShape& shape);

/// A rectangle stays one if it is moved, rotated, or scaled along its sides; otherwise it becomes a
/// path.
WindowShape mapped(const WindowShape& shape, const AffineMap& map);

/// The shape, stretched so that its frame becomes `frame`, which has the same angle. A side of
/// length zero is only moved; a path is not squeezed to one.
WindowShape fitted(const WindowShape& shape, const WindowFrame& frame);

/// The shape, rotated about the centre of its frame (radians, from x towards y). A rectangle that
/// is rotated by a multiple of 90° has the angle 0.
WindowShape rotated(const WindowShape& shape, double angle);

/// `frame` with the box `box`, both given in the frame's own directions, at the centre of `frame`.
/// The corner that both have in common stays where it is.
WindowFrame resized(const WindowFrame& frame, const clipping::Window& box);

/// A point in the frame's own directions, in which the frame is its box; and back.
Point intoFrame(const WindowFrame& frame, const Point& p);
Point outOfFrame(const WindowFrame& frame, const Point& p);

} // namespace app
