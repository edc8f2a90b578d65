// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/direction.h"

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <cmath>

namespace app {

Point directionOf(double degrees)
{
    const auto exact = [](double value) {
        const double twice = std::round(2 * value);
        return std::abs(2 * value - twice) < 1e-14 ? twice / 2 : value;
    };
    const double angle = glm::radians(std::remainder(degrees, 360));
    // +0, because y grows down and -0 is no useful coordinate
    return {exact(std::cos(angle)), exact(-std::sin(angle)) + 0.0};
}

double degreesOf(const Point& vector)
{
    return vector == Point(0) ? 0 : glm::degrees(std::atan2(-vector.y + 0.0, vector.x));
}

Point turnedToStep(const Point& from, const Point& to)
{
    constexpr double step = 15;
    const Point along = to - from;
    const Point direction = directionOf(std::round(degreesOf(along) / step) * step);
    return from + direction * glm::dot(along, direction);
}

} // namespace app
