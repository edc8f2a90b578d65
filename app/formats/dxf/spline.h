// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <glm/vec3.hpp>

#include <vector>

namespace app::dxf {

/// A B-spline in the plane of the page, perhaps rational: its points are (x · w, y · w, w).
struct Spline {
    std::size_t degree = 3;
    std::vector<double> knots{};
    std::vector<glm::dvec3> points{};

    /// Whether there are as many knots as the points need, in ascending order.
    bool isValid() const;
};

/// The spline as Bézier curves that are nowhere farther from it than `tolerance`: exact for those
/// of degree 3 or less without weights.
Subpath pathOf(const Spline& spline, double tolerance);

/// A smooth curve through points. A tangent of length 0 is free.
Subpath pathThrough(const std::vector<Point>& points, const Point& beginTangent,
                    const Point& endTangent, bool closed);

} // namespace app::dxf
