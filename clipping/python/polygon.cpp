// SPDX-License-Identifier: MIT
#include "clipping/polygon/prepared.h"
#include "clipping/python/module.h"

#include <algorithm>

namespace clipping::python {

ConvexPolygon polygonOf(const std::vector<std::array<double, 2>>& corners)
{
    ConvexPolygon polygon;
    for (const auto& [x, y] : corners)
        polygon.corners.push_back({x, y});
    if (prepared(polygon))
        return polygon;
    std::ranges::reverse(polygon.corners);
    if (prepared(polygon))
        return polygon;
    throw pybind11::value_error("polygon must be convex, with finite numbers, and go round once");
}

} // namespace clipping::python
