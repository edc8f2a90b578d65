// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <vector>

// All coordinates are the drawing's user units, y down (the SVG's), transforms already applied.

namespace app {

using Point = glm::dvec2;

/// One segment of a path, from where the last one ended: a line, or a cubic Bézier curve.
struct PathSegment {
    Point to;
    Point control1{}, control2{}; ///< zero for a line
    bool curved = false;
    friend bool operator==(const PathSegment&, const PathSegment&) = default;
};

/// A connected run of segments. A closed one returns to `start` by a line if it is not there yet.
/// No segments at all: a single point.
struct Subpath {
    Point start;
    std::vector<PathSegment> segments;
    bool closed = false;
    friend bool operator==(const Subpath&, const Subpath&) = default;
};

} // namespace app
