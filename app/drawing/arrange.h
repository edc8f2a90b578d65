// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "clipping/geometry.h"

#include <optional>
#include <span>
#include <vector>

// Where boxes go when they are aligned, spread, made as large as one of them, or repeated.

namespace app {

enum class AlignTo : std::uint8_t { Least, Middle, Most }; ///< left or top, middle, right or bottom

/// The way of each box to the same side or the middle of `to`, along an axis (0: x, 1: y).
std::vector<Point> aligned(std::span<const clipping::Window> boxes, const clipping::Window& to,
                           int axis, AlignTo side);

/// The way of each box to equal gaps, which may be negative, in the order of their middles. The
/// outer two stay, or go to the sides of `over`. Boxes between which there is no gap to change
/// stay.
std::vector<Point> spread(std::span<const clipping::Window> boxes, int axis,
                          const std::optional<clipping::Window>& over = {});

/// The map of each box to the width or height of `model`, about its top left corner. A box without
/// an extent stays.
std::vector<AffineMap> sameSize(std::span<const clipping::Window> boxes,
                                const clipping::Window& model, bool width, bool height);

/// The maps from an object to its copies in rows and columns, row by row, without the first place.
std::vector<AffineMap> grid(int rows, int columns, const Point& step);

/// The maps from an object to its copies about a point: `count` places with the first one, spread
/// over `degrees`. Over a whole turn the last one does not lie on the first.
std::vector<AffineMap> circle(int count, double degrees, const Point& about);

} // namespace app
