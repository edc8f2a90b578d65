// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/gradient.h"

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

double spreadTo(GradientShape::Spread spread, double t)
{
    using Spread = GradientShape::Spread;
    if (spread == Spread::Pad)
        return std::clamp(t, 0.0, 1.0);
    if (spread == Spread::Repeat)
        return t - std::floor(t);
    return std::abs(std::remainder(t, 2.0));
}

std::optional<double> along(const GradientShape& shape, const Point& point)
{
    const Point axis = shape.to - shape.from, step = point - shape.from;
    const double square = axis.x * axis.x + axis.y * axis.y;
    return square > 0 ? std::optional((step.x * axis.x + step.y * axis.y) / square) : std::nullopt;
}

// The largest t whose circle, with its centre between focus and centre, goes through the point.
std::optional<double> throughCircles(const GradientShape& shape, const Point& point)
{
    if (!(shape.radius > 0))
        return std::nullopt;
    Point axis = shape.to - shape.from;
    const double grows = shape.radius - shape.focusRadius;
    const double most = 0.999 * grows, apart = std::hypot(axis.x, axis.y);
    if (most > 0 && apart > most) // SVG 1.1 moves the focus into the circle
        axis *= most / apart;
    const Point step = point - (shape.to - axis);
    const double a = axis.x * axis.x + axis.y * axis.y - grows * grows;
    const double b = step.x * axis.x + step.y * axis.y + shape.focusRadius * grows;
    const double c = step.x * step.x + step.y * step.y - shape.focusRadius * shape.focusRadius;
    if (a == 0)
        return b != 0 ? std::optional(c / (2 * b)) : std::nullopt;
    const double root = std::sqrt(std::max(b * b - a * c, 0.0));
    return std::max((b + root) / a, (b - root) / a);
}

} // namespace

Rgba colourAt(const GradientStops& stops, double t)
{
    const auto after = std::ranges::find_if(stops, [&](const auto& stop) { return stop.at > t; });
    if (after == stops.begin())
        return stops.front().colour;
    if (after == stops.end())
        return stops.back().colour;
    const GradientStop& before = after[-1];
    const double share = (t - before.at) / (after->at - before.at);
    Rgba colour{};
    for (std::size_t i = 0; i < colour.size(); ++i)
        colour[i] = before.colour[i] + share * (after->colour[i] - before.colour[i]);
    return colour;
}

std::optional<double> placeAlong(const GradientShape& shape, const Point& point)
{
    const auto t = shape.radial ? throughCircles(shape, point) : along(shape, point);
    return t && std::isfinite(*t) ? std::optional(spreadTo(shape.spread, *t)) : std::nullopt;
}

} // namespace app::svg
