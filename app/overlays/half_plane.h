// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>

namespace app {

/// The closed half of the plane that a normal points into.
struct HalfPlane {
    Point on{};     ///< a point of its border
    Point normal{}; ///< of any length; {0, 0}: the whole plane
    /// The other half; the border belongs to both.
    HalfPlane other() const { return {on, -normal}; }
};

/// Whether a point lies strictly beyond an edge of the window. Not for Edge::None.
bool isBeyond(const Point& p, clipping::Edge edge, const clipping::Window& window);
/// What lies beyond an edge of the window.
HalfPlane beyond(clipping::Edge edge, const clipping::Window& window);
/// The side of the line through `from` and `through` that `inside` lies in; the whole plane where
/// all three lie in one line.
HalfPlane sideOf(const Point& from, const Point& through, const Point& inside);

/// The corners of a convex area that lies in all these half-planes and in the rectangle; none
/// where that has no inside.
std::vector<Point> common(const clipping::Window& rectangle, std::span<const HalfPlane> halves);

/// The two corners of an edge.
struct EdgeCorners {
    Point one, other;
};
EdgeCorners cornersOf(clipping::Edge edge, const clipping::Window& window);

} // namespace app
