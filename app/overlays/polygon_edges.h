// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
#include <span>

// The edges of a convex polygon, numbered from 1 as by clipping::polygonEdgeOfA: edge 1 begins at
// the first corner.

namespace app {

/// From the corner where the edge begins to the next one.
clipping::Segment polygonEdge(std::size_t number, std::span<const Point> corners);
/// The part of the edge's infinite line in a rectangle; empty if there is none.
std::optional<clipping::Segment> polygonEdgeLine(std::size_t number, std::span<const Point> corners,
                                                 const clipping::Window& seen);
/// The number of the edge on which a point lies: the nearest one.
std::size_t polygonEdgeAt(const Point& p, std::span<const Point> corners);

} // namespace app
