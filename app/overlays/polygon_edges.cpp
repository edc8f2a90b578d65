// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/polygon_edges.h"

#include "clipping/algorithm.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace app {

clipping::Segment polygonEdge(std::size_t number, std::span<const Point> corners)
{
    return {corners[number - 1], corners[number % corners.size()]};
}

std::optional<clipping::Segment> polygonEdgeLine(std::size_t number, std::span<const Point> corners,
                                                 const clipping::Window& seen)
{
    const auto [from, to] = polygonEdge(number, corners);
    const double length = glm::distance(from, to);
    if (!(length > 0))
        return std::nullopt;
    // Long enough to cross the rectangle, wherever the edge lies.
    const double far = glm::distance(from, seen.min) + glm::distance(seen.min, seen.max);
    const Point along = far / length * (to - from);
    return clipping::exactAlgorithm().corrected.clip({from - along, from + along}, seen);
}

std::size_t polygonEdgeAt(const Point& p, std::span<const Point> corners)
{
    const auto distance = [&](std::size_t number) {
        const auto [from, to] = polygonEdge(number, corners);
        const Point along = to - from;
        const double square = glm::dot(along, along);
        const double share =
            square > 0 ? glm::clamp(glm::dot(p - from, along) / square, 0.0, 1.0) : 0;
        return glm::distance(p, from + share * along);
    };
    std::size_t nearest = 1;
    for (std::size_t number = 2; number <= corners.size(); ++number)
        if (distance(number) < distance(nearest))
            nearest = number;
    return nearest;
}

} // namespace app
