// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/recipe.h"
#include "app/drawing/gesture_measure.h"

// Shapes that are drawn from their centre, by the numbers of polygonMeasure() and starMeasure().

namespace app {

constexpr double leastCorners = 3, mostCorners = 1000; ///< most: by the arrow keys

/// A regular polygon. Opposite: a corner is at `to`; Centre: the middle of a side.
StarRecipe polygonTo(const Point& centre, const Point& to, const Numbers& numbers, Anchor anchor);
/// A star with an outer corner at `to`.
StarRecipe starTo(const Point& centre, const Point& to, const Numbers& numbers);

/// The numbers of the first polygon and star: a hexagon, and a star whose sides continue on the
/// other side of their neighbours.
Numbers usualPolygon();
Numbers usualStar();

} // namespace app
