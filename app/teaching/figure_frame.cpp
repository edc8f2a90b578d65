// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_frame.h"

#include "app/base/finite.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double far = 1e6; // pixels; QPainter still handles such coordinates

/// The position of a number between two others, from 0 to 1 and beyond. Computed with halves, so
/// that the largest numbers do not overflow.
double share(double value, double low, double high)
{
    return (value / 2 - low / 2) / (high / 2 - low / 2);
}

/// The interval to be shown on one axis.
struct Span {
    double low, high;
    double middle() const { return low / 2 + high / 2; }
    double half() const { return high / 2 - low / 2; }
    void include(double value) { low = std::min(low, value), high = std::max(high, value); }
};

/// The window, and the line's ends unless they are very far from it.
Span spanOf(const TracedLine& tracedLine, glm::length_t axis, double reach)
{
    const auto& [min, max] = tracedLine.window;
    Span span{min[axis], max[axis]};
    const double least = span.low - reach, most = span.high + reach;
    for (const Point& end : {tracedLine.line.a, tracedLine.line.b})
        if (std::isfinite(end[axis]))
            span.include(std::clamp(end[axis], std::isfinite(least) ? least : span.low,
                                    std::isfinite(most) ? most : span.high));
    return span;
}

/// How far outside the window points are still shown; for a window that is a point, any distance.
double reachOf(const clipping::Window& window)
{
    const Point half = window.max / 2.0 - window.min / 2.0;
    const double larger = std::max(half.x, half.y);
    return larger > 0 ? 2.4 * larger : std::numeric_limits<double>::max() / 8;
}

/// The least half extent of a picture on an axis: more than rounding errors.
double leastHalf(const Span& x, const Span& y)
{
    const double most = std::max(std::abs(x.middle()), std::abs(y.middle()));
    return std::max(most * 2e-15, 1e-290);
}

Span around(double middle, double half)
{
    constexpr double most = std::numeric_limits<double>::max();
    return {std::max(middle - half, -most), std::min(middle + half, most)};
}

} // namespace

QPointF FigureFrame::at(const Point& point) const
{
    const double x = share(point.x, seen.min.x, seen.max.x);
    const double down = share(point.y, seen.min.y, seen.max.y);
    const auto place = [](double part, double length) {
        return std::isnan(part) ? far : std::clamp(part * length, -far, far);
    };
    return {place(x, size.width()), place(y == YAxis::Down ? down : 1 - down, size.height())};
}

Point FigureFrame::pointAt(const QPointF& place) const
{
    const double x = place.x() / size.width(), down = place.y() / size.height();
    const double up = y == YAxis::Down ? down : 1 - down;
    return {seen.min.x * (1 - x) + seen.max.x * x, seen.min.y * (1 - up) + seen.max.y * up};
}

std::optional<QLineF> FigureFrame::part(const clipping::Segment& line) const
{
    const auto piece = clipping::exactAlgorithm().corrected.clip(line, seen);
    return piece ? std::optional(QLineF(at(piece->a), at(piece->b))) : std::nullopt;
}

bool FigureFrame::shows(const Point& point) const
{
    return isFinite(point) && point.x >= seen.min.x && point.x <= seen.max.x
           && point.y >= seen.min.y && point.y <= seen.max.y;
}

FigureFrame figureFrame(const TracedLine& tracedLine, const QSizeF& size, const QFont& font)
{
    const double reach = reachOf(tracedLine.window);
    Span x = spanOf(tracedLine, 0, reach), y = spanOf(tracedLine, 1, reach);
    const double em = font.pixelSize();
    const auto inner = [](double length, double margin) {
        return length - 2 * std::min(margin, length * 0.22);
    };
    const double width = inner(size.width(), 8 * em), height = inner(size.height(), 5 * em);
    const double perPixel =
        std::max({x.half() / width, y.half() / height, leastHalf(x, y) / std::min(width, height)});
    x = around(x.middle(), perPixel * size.width());
    y = around(y.middle(), perPixel * size.height());
    return {
        .size = size, .seen = {{x.low, y.low}, {x.high, y.high}}, .y = tracedLine.y, .font = font};
}

FigureColours figureColours(Ground ground)
{
    return ground == Ground::Light ? FigureColours{.paper = 0xFFFFFF,
                                                   .text = 0x1B1E23,
                                                   .muted = 0x565D67,
                                                   .rule = 0xD0D4DA,
                                                   .border = 0xAEB5BF,
                                                   .window = 0xC2410C,
                                                   .highlight = 0x1D63C9,
                                                   .onHighlight = 0xFFFFFF,
                                                   .tint = 0xDCE8FA,
                                                   .beyond = 0xF3F4F6}
                                   : FigureColours{.paper = 0x1E2023,
                                                   .text = 0xE7E9EC,
                                                   .muted = 0xA6ACB6,
                                                   .rule = 0x3A3D44,
                                                   .border = 0x5C626C,
                                                   .window = 0xFF8F52,
                                                   .highlight = 0x5B9BFF,
                                                   .onHighlight = 0x10131A,
                                                   .tint = 0x2C3F60,
                                                   .beyond = 0x1A1B1E};
}

} // namespace app
