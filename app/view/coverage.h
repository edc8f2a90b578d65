// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picture.h"

#include <QImage>

namespace app {

/// How much of each pixel contours cover: the same sums of signed areas that QPainter makes of a
/// path (within 5 of 255), contour by contour. QPainter looks through the edges that a row of
/// pixels already has for every new one, so its time grows with their square; here it grows with
/// their length.
class Coverage {
public:
    /// Of these pixels; what is added is in device pixels.
    explicit Coverage(const QRect& pixels);

    /// An area bounded by these points and the line from the last to the first.
    void add(std::span<const QPointF> contour);

    /// The pixels in one colour, as opaque as they are covered.
    QImage inked(FillRule rule, const Colour& colour) const;

private:
    void addEdge(const QPointF& a, const QPointF& b);
    void addToRow(int row, double x0, double x1, double height);

    QRect pixels_;
    std::size_t stride_;
    std::vector<float>
        sums_; ///< in each pixel, how much its cover differs from its left neighbour's
};

/// Whether summing takes less time than QPainter for an area whose edges go up and down by `height`
/// device pixels in all.
bool worthSumming(double height, const QRect& pixels);

} // namespace app
