// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <vector>

// All coordinates are in user units of the drawing, y down (as in SVG), with transforms already
// applied.

namespace app {

using Point = glm::dvec2;

/// The product of their lengths and the sine of the angle from u to v.
inline double cross(const Point& u, const Point& v) { return u.x * v.y - u.y * v.x; }

/// One segment of a path, from the end of the previous one: a line or a cubic Bézier curve.
struct PathSegment {
    Point to;
    Point control1{}, control2{}; ///< zero for a line
    bool curved = false;
    friend bool operator==(const PathSegment&, const PathSegment&) = default;
};

/// A connected run of segments. A closed subpath returns to `start` by a line if it does not end
/// there. Without segments it is a single point.
struct Subpath {
    Point start;
    std::vector<PathSegment> segments;
    bool closed = false;
    friend bool operator==(const Subpath&, const Subpath&) = default;
};

/// The same path from its end to its start.
Subpath reversedPath(const Subpath& path);

} // namespace app
