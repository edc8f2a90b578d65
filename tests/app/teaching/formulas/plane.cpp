// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/teaching/formulas/plane.h"

namespace app::formulas {

std::array<double, 4> Plane::of(const clipping::Segment& s) const
{
    const auto at = [&](const glm::dvec2& p, std::size_t k) {
        return isNegative[k] ? -p[axes[k]] : p[axes[k]];
    };
    return {at(s.a, 0), at(s.a, 1), at(s.b, 0), at(s.b, 1)};
}

clipping::Edge Plane::of(clipping::Edge edge) const
{
    if (edge == clipping::Edge::NoEdge)
        return edge;
    const int axis = int(clipping::axisOf(edge)), k = axes[0] == axis ? 0 : 1;
    const bool isLower = edge == clipping::lowerEdge(axis);
    return isLower != isNegative[std::size_t(k)] ? clipping::lowerEdge(k) : clipping::upperEdge(k);
}

} // namespace app::formulas
