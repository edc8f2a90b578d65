// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"

#include <optional>

namespace ui {

enum class LineEnd : std::uint8_t { One, Two };

/// An end of the line in a figure, as the pointer takes hold of it and moves it.
inline const app::Point& endOf(const clipping::Segment& line, LineEnd end)
{
    return end == LineEnd::One ? line.a : line.b;
}
clipping::Segment withEnd(clipping::Segment line, LineEnd end, const app::Point& point);

/// The end that is seen within reach of a place of the picture; the nearer one.
std::optional<LineEnd> endAt(const app::FigureFrame& frame, const clipping::Segment& line,
                             const QPointF& place);

/// How much of the drawing a pixel of the picture is.
double perPixel(const app::FigureFrame& frame);
/// The power of ten that is about a pixel: ends that are moved by hand lie on its multiples.
double handStep(const app::FigureFrame& frame);

/// A point moved by so many of these steps along each axis.
app::Point nudged(const app::FigureFrame& frame, const app::Point& point, double x, double y);

enum class Snapping : std::uint8_t { Off, ToWindow };
/// Where an end comes that is moved to a place: on a near edge or corner of the window, or else to
/// a short number.
app::Point handPoint(const app::FigureFrame& frame, const clipping::Window& window,
                     const QPointF& place, Snapping snapping);

} // namespace ui
