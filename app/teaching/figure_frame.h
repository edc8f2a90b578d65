// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QFont>
#include <QLineF>
#include <QRectF>

namespace app {

/// How a figure lies in its picture.
struct FigureFrame {
    QSizeF size;           ///< of the picture, in its own units: logical pixels
    clipping::Window seen; ///< what of the drawing fills it, in the picture's proportions
    YAxis y = YAxis::Up;
    QFont font;        ///< with a pixel size; strokes, marks and distances go with it
    QRectF reserved{}; ///< labels keep clear of this part of the picture
    bool windowIsPage = false; ///< the line is clipped at the page: there is no clip window

    QRectF picture() const { return {QPointF(), size}; }
    /// Where a point of the drawing is in the picture. Always finite: what is very far away is only
    /// somewhere far away.
    QPointF at(const Point& point) const;
    /// The way back.
    Point pointAt(const QPointF& place) const;
    /// Where the part of a line that can be seen is; nothing if none of it can.
    std::optional<QLineF> part(const clipping::Segment& line) const;
    /// Whether a point is in the picture; false for what is no point.
    bool shows(const Point& point) const;
    /// The size of a stroke's unit: 1 with a font of 13 pixels.
    double unit() const { return font.pixelSize() / 13.0; }
};

/// Shows window and line with room for labels, the same at every step. Of a line that is much
/// longer than the window only the part near it is seen.
FigureFrame figureFrame(const Specimen& specimen, const QSizeF& size, const QFont& font);

/// The same, but a line that would be a mere dot beside its window fills a good part of the
/// picture, with the edges that it crosses; unless then nothing of the window could be seen.
FigureFrame nearFrame(const Specimen& specimen, const QSizeF& size, const QFont& font);

} // namespace app
