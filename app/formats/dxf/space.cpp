// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/space.h"

#include "app/document/direction.h"

#include <glm/geometric.hpp>

#include <cmath>

namespace app::dxf {

double Space::scale() const
{
    return std::sqrt(std::abs(axes[0].x * axes[1].y - axes[0].y * axes[1].x));
}

Space operator*(const Space& after, const Space& before)
{
    return {after.axes * before.axes, after(before.offset)};
}

Space moved(const glm::dvec3& by) { return {glm::dmat3(1), by}; }

Space turned(double degrees)
{
    const Point along = directionOf(degrees); // y down
    Space space;
    space.axes[0] = {along.x, -along.y, 0};
    space.axes[1] = {along.y, along.x, 0};
    return space;
}

Space scaled(const glm::dvec3& factors)
{
    Space space;
    for (int axis = 0; axis < 3; ++axis)
        space.axes[axis][axis] = factors[axis];
    return space;
}

Space planeOf(const glm::dvec3& normal)
{
    const double length = glm::length(normal);
    if (!(length > 0) || (normal.x == 0 && normal.y == 0 && normal.z > 0))
        return {};
    const glm::dvec3 n = normal / length;
    constexpr double near = 1.0 / 64;
    const bool nearZ = std::abs(n.x) < near && std::abs(n.y) < near;
    const glm::dvec3 x =
        glm::normalize(glm::cross(nearZ ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1), n));
    return {glm::dmat3(x, glm::normalize(glm::cross(n, x)), n), glm::dvec3(0)};
}

} // namespace app::dxf
