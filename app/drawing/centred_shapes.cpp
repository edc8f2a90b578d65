// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/centred_shapes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {
namespace {

constexpr double pentagram = 0.381966011250105; // the inner radius where the sides continue

int cornersOf(const Numbers& numbers) { return std::max(int(leastCorners), int(numbers[2])); }

} // namespace

StarRecipe polygonTo(const Point& centre, const Point& to, const Numbers& numbers, Anchor anchor)
{
    const int corners = cornersOf(numbers);
    const Point way = to - centre;
    const double radius = glm::length(way), angle = std::atan2(way.y, way.x);
    const double half = std::numbers::pi / corners;
    if (anchor == Anchor::Centre)
        return {centre, radius / std::cos(half), 0, angle + half, corners};
    return {centre, radius, 0, angle, corners};
}

StarRecipe starTo(const Point& centre, const Point& to, const Numbers& numbers)
{
    const Point way = to - centre;
    const double radius = glm::length(way);
    return {centre, radius, radius * numbers[3], std::atan2(way.y, way.x), cornersOf(numbers)};
}

Numbers usualPolygon() { return {0, 0, 6}; }
Numbers usualStar() { return {0, 0, 5, pentagram}; }

} // namespace app
