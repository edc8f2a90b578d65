// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/microscope/line_drag.h"

#include "app/view/snapping/snapper.h"

#include <QLineF>

#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr double reach = 14, snapReach = 8; // pixels

/// Rounds to a multiple of `step`. For steps below 1 it divides by an integral power of ten, so
/// that 0.1 is the double nearest to 0.1.
double rounded(double value, double step)
{
    return step < 1 ? std::round(value * std::round(1 / step)) / std::round(1 / step)
                    : std::round(value / step) * step;
}

} // namespace

clipping::Segment withEnd(clipping::Segment line, LineEnd end, const app::Point& point)
{
    (end == LineEnd::One ? line.a : line.b) = point;
    return line;
}

std::optional<LineEnd> endAt(const app::FigureFrame& frame, const clipping::Segment& line,
                             const QPointF& place)
{
    const auto distance = [&](LineEnd end) {
        const app::Point& point = endOf(line, end);
        return frame.shows(point) ? QLineF(frame.at(point), place).length() : 2 * reach;
    };
    const double one = distance(LineEnd::One), two = distance(LineEnd::Two);
    if (std::min(one, two) > reach)
        return std::nullopt;
    return one < two ? LineEnd::One : LineEnd::Two;
}

double perPixel(const app::FigureFrame& frame)
{
    return (frame.seen.max.x / 2 - frame.seen.min.x / 2) / frame.size.width() * 2;
}

double handStep(const app::FigureFrame& frame)
{
    return std::pow(10.0, std::ceil(std::log10(perPixel(frame)) - 0.3));
}

app::Point nudged(const app::FigureFrame& frame, const app::Point& point, double x, double y)
{
    const double step = handStep(frame);
    return {x == 0 ? point.x : rounded(point.x + x * step, step),
            y == 0 ? point.y : rounded(point.y + y * step, step)};
}

app::Point handPoint(const app::FigureFrame& frame, const clipping::Window& window,
                     const QPointF& place, Snapping snapping)
{
    const app::Point free = frame.pointAt(place);
    const double step = handStep(frame);
    app::Point point(rounded(free.x, step), rounded(free.y, step));
    if (snapping == Snapping::Off)
        return point;
    if (const auto near = app::snapToEdges(free, snapReach * perPixel(frame), window)) {
        point.x = near->point.x == free.x ? point.x : near->point.x;
        point.y = near->point.y == free.y ? point.y : near->point.y;
    }
    return point;
}

} // namespace ui
