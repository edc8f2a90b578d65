// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

namespace app {

/// Closed rings of straight edges, in document coordinates. The last corner of a ring is joined to
/// its first. What they enclose follows the fill rule.
struct WindowOutline {
    std::vector<std::vector<Point>> rings;
    FillRule rule = FillRule::NonZero;
};

/// The border of a clip window's shape as straight edges. The corners lie on the shape's border,
/// and no edge is farther than `tolerance` (user units, > 0) from it: ellipses and circles become
/// inscribed polygons. Empty for a rectangle that contains nothing.
WindowOutline outlineOf(const WindowShape& shape, double tolerance);

/// The same, where ellipses are the four Bézier curves that objects have, up to 2.73e-4 of a radius
/// beyond them.
WindowOutline drawnOutlineOf(const WindowShape& shape, double tolerance);

/// The ellipse that the shape is; null for any other.
const EllipseRecipe* ellipseOf(const WindowShape& shape);

/// The tolerance of curved clip windows, on paper.
constexpr double windowMillimetres = 0.01;

} // namespace app
