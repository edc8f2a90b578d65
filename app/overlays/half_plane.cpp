// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/half_plane.h"

#include <glm/geometric.hpp>

namespace app {

using clipping::Edge;
using clipping::Window;

namespace {

/// Sutherland and Hodgman's step: the part of a convex polygon in one half-plane.
std::vector<Point> part(const std::vector<Point>& polygon, const HalfPlane& half)
{
    std::vector<Point> kept;
    const auto depth = [&](const Point& p) { return glm::dot(half.normal, p - half.on); };
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &here = polygon[i], &next = polygon[(i + 1) % polygon.size()];
        const double now = depth(here), then = depth(next);
        if (now >= 0)
            kept.push_back(here);
        if ((now > 0 && then < 0) || (now < 0 && then > 0))
            kept.push_back(here + now / (now - then) * (next - here));
    }
    return kept;
}

double area(const std::vector<Point>& polygon)
{
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
    return std::abs(sum) / 2;
}

} // namespace

bool isBeyond(const Point& p, Edge edge, const Window& window)
{
    const auto axis = clipping::axisOf(edge);
    const double level = clipping::levelOf(edge, window);
    return edge == clipping::lowerEdge(axis) ? p[axis] < level : p[axis] > level;
}

HalfPlane beyond(Edge edge, const Window& window)
{
    const bool low = edge == clipping::lowerEdge(clipping::axisOf(edge));
    Point normal{0, 0};
    normal[clipping::axisOf(edge)] = low ? -1 : 1;
    return {low ? window.min : window.max, normal};
}

HalfPlane sideOf(const Point& from, const Point& through, const Point& inside)
{
    const Point along = through - from;
    const double side = cross(along, inside - from);
    if (side == 0 || !std::isfinite(side))
        return {from, {0, 0}};
    const Point left(-along.y, along.x);
    return {from, side > 0 ? left : -left};
}

std::vector<Point> common(const Window& rectangle, std::span<const HalfPlane> halves)
{
    const auto& [min, max] = rectangle;
    if (!(min.x < max.x && min.y < max.y))
        return {};
    std::vector<Point> polygon{min, {max.x, min.y}, max, {min.x, max.y}};
    for (const HalfPlane& half : halves)
        polygon = part(polygon, half);
    return area(polygon) > 0 ? polygon : std::vector<Point>{};
}

EdgeCorners cornersOf(Edge edge, const Window& window)
{
    const auto axis = clipping::axisOf(edge);
    EdgeCorners corners{window.min, window.max};
    corners.one[axis] = corners.other[axis] = clipping::levelOf(edge, window);
    return corners;
}

} // namespace app
