// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"

#include <optional>

namespace ui {

enum class LineEnd : std::uint8_t { One, Two };

/// Hit-testing and moving an end of the line in a figure.
inline const app::Point& endOf(const clipping::Segment& line, LineEnd end)
{
    return end == LineEnd::One ? line.a : line.b;
}
clipping::Segment withEnd(clipping::Segment line, LineEnd end, const app::Point& point);

/// The visible end within reach of a place in the picture; if both are, the nearer one.
std::optional<LineEnd> endAt(const app::FigureFrame& frame, const clipping::Segment& line,
                             const QPointF& place);

/// The size of one pixel of the picture, in drawing units.
double perPixel(const app::FigureFrame& frame);
/// A power of ten between 0.5 and 5 times perPixel(): ends moved by hand lie on its multiples.
double handStep(const app::FigureFrame& frame);

/// A point moved by `x` and `y` times handStep() along the axes.
app::Point nudged(const app::FigureFrame& frame, const app::Point& point, double x, double y);

enum class Snapping : std::uint8_t { Off, ToWindow };
/// The new position of an end that is moved to a place in the picture: on a nearby window edge or
/// corner, else at multiples of handStep().
app::Point handPoint(const app::FigureFrame& frame, const clipping::Window& window,
                     const QPointF& place, Snapping snapping);

} // namespace ui
