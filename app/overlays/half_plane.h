// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>

namespace app {

/// The closed half-plane that a normal points into.
struct HalfPlane {
    Point on{};     ///< a point on its border
    Point normal{}; ///< of any length; {0, 0}: the whole plane
    /// The complementary half-plane; both contain the border.
    HalfPlane other() const { return {on, -normal}; }
};

/// Whether a point lies strictly beyond an edge of the window. Not for Edge::NoEdge.
bool isBeyond(const Point& p, clipping::Edge edge, const clipping::Window& window);
/// The half-plane beyond an edge of the window.
HalfPlane beyond(clipping::Edge edge, const clipping::Window& window);
/// The half-plane on the side of `inside`, bounded by the line through `from` and `through`; the
/// whole plane if the three points are collinear.
HalfPlane sideOf(const Point& from, const Point& through, const Point& inside);

/// The corners of the convex area that these half-planes and the rectangle have in common; empty if
/// that area is empty or degenerate.
std::vector<Point> common(const clipping::Window& rectangle, std::span<const HalfPlane> halves);

/// The two corners of an edge.
struct EdgeCorners {
    Point one, other;
};
EdgeCorners cornersOf(clipping::Edge edge, const clipping::Window& window);

} // namespace app
