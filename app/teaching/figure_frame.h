// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"
#include "app/view/algorithm_mark.h"

#include <QColor>
#include <QFont>
#include <QLineF>
#include <QRectF>

#include <vector>

namespace app {

/// The position and scale of a figure in its picture.
struct FigureFrame {
    QSizeF size;           ///< of the picture, in its own units: logical pixels
    clipping::Window seen; ///< the part of the drawing that fills it, in the picture's proportions
    YAxis y = YAxis::Up;
    QFont font;                  ///< with a pixel size; strokes, marks and distances scale with it
    QRectF reserved{};           ///< labels do not cover this part of the picture
    std::vector<QRectF> discs{}; ///< nor these, those of answers
    bool hasScale = false;       ///< it has a scale bar
    bool countsSteps = true;     ///< labels name steps by their numbers

    QRectF picture() const { return {QPointF(), size}; }
    /// Converts a point of the drawing to the picture. Always finite: the result for a very distant
    /// point is only some distant point.
    QPointF at(const Point& point) const;
    /// The inverse.
    Point pointAt(const QPointF& place) const;
    /// The part of a line inside the picture; empty if none of it is.
    std::optional<QLineF> part(const clipping::Segment& line) const;
    /// Whether a point is in the picture; false for NaNs and infinities.
    bool shows(const Point& point) const;
    /// The size of a stroke's unit: 1 with a font of 13 pixels.
    double unit() const { return font.pixelSize() / 13.0; }
};

/// Shows window and line with room for labels, the same at every step. For a line that is much
/// longer than the window, only the part near the window is shown.
FigureFrame figureFrame(const TracedLine& tracedLine, const QSizeF& size, const QFont& font);

/// The colours of a figure: the program's own colours, each with a single meaning.
struct FigureColours {
    QColor paper;             ///< the background
    QColor text, muted, rule; ///< text: the remaining part of the line; muted: discarded parts
    QColor border;            ///< the infinite lines of the edges
    QColor window;            ///< only the clip window
    QColor highlight, onHighlight,
        tint;      ///< the subject of this step; text on it; its background in lists
    QColor beyond; ///< the ground beyond the edge of this step
};
FigureColours figureColours(Ground ground);

} // namespace app
