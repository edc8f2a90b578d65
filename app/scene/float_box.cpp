// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/float_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float floatInfinity = std::numeric_limits<float>::infinity();

float roundedDown(double number)
{
    const auto nearest = float(number);
    return nearest > number ? std::nextafter(nearest, -floatInfinity) : nearest;
}

float roundedUp(double number)
{
    const auto nearest = float(number);
    return nearest < number ? std::nextafter(nearest, floatInfinity) : nearest;
}

} // namespace

FloatBox boxAround(std::span<const clipping::Segment> segments)
{
    clipping::Window box{{infinity, infinity}, {-infinity, -infinity}};
    double zero = 0; // NaN if a number is not finite
    for (const auto& [a, b] : segments) {
        box.min = {std::min({box.min.x, a.x, b.x}), std::min({box.min.y, a.y, b.y})};
        box.max = {std::max({box.max.x, a.x, b.x}), std::max({box.max.y, a.y, b.y})};
        zero += (a.x - a.x) + (a.y - a.y) + (b.x - b.x) + (b.y - b.y);
    }
    box.min += zero;
    box.max += zero;
    return {roundedDown(box.min.x), roundedDown(box.min.y), roundedUp(box.max.x),
            roundedUp(box.max.y)};
}

FloatBox united(const FloatBox& a, const FloatBox& b)
{
    if (std::isnan(a.minX) || std::isnan(b.minX))
        return std::isnan(a.minX) ? a : b;
    return {std::min(a.minX, b.minX), std::min(a.minY, b.minY), std::max(a.maxX, b.maxX),
            std::max(a.maxY, b.maxY)};
}

} // namespace app
