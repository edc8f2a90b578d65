// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/convex_outline.h"

#include "clipping/algorithm.h"

#include <algorithm>

namespace app {

// Whether the library takes it for a convex polygon: then each corner is inside.
static bool containsItsCorner(const clipping::ConvexPolygon& polygon)
{
    const Point& corner = polygon.corners.front();
    return clipping::exactAlgorithm().polygon->clip({corner, corner}, polygon).has_value();
}

clipping::ConvexPolygon convexPolygonOf(const std::vector<std::vector<Point>>& rings)
{
    if (rings.size() != 1 || rings.front().size() < 3)
        return {};
    clipping::ConvexPolygon polygon{rings.front()};
    const bool anticlockwise = containsItsCorner(polygon);
    if (anticlockwise) {
        clipping::ConvexPolygon reversed{{polygon.corners.rbegin(), polygon.corners.rend()}};
        return containsItsCorner(reversed) ? clipping::ConvexPolygon() : polygon; // both: no area
    }
    std::ranges::reverse(polygon.corners);
    return containsItsCorner(polygon) ? polygon : clipping::ConvexPolygon();
}

} // namespace app
