// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/clip_windows.h"

#include <array>

namespace app {

/// The rectangle that the handles of a clip window stand on, rotated by `angle` (radians, from x
/// towards y) about its centre.
using WindowFrame = RectangleShape;

Point centreOf(const clipping::Window& box);

/// The corners, from the smallest x and y towards larger x; without a rotation they have the bits
/// of the box.
std::array<Point, 4> cornersOf(const WindowFrame& frame);

/// A point in the frame's own directions, in which the frame is its box; and back.
Point intoFrame(const WindowFrame& frame, const Point& p);
Point outOfFrame(const WindowFrame& frame, const Point& p);

/// `frame` with the box `box`, both given in the frame's own directions, at the centre of `frame`.
/// The corner that both have in common stays where it is.
WindowFrame resized(const WindowFrame& frame, const clipping::Window& box);

/// Scales along axes that are turned by `angle`.
AffineMap scalingAlong(double angle, const Point& factors, const Point& about);

/// The map of `from` onto `to`, which has the same angle. A side without extent keeps its factor 1.
AffineMap fitting(const WindowFrame& from, const WindowFrame& to);

} // namespace app
