// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"

#include <QImage>

namespace app {

/// The share of each pixel that contours cover: the same sums of signed areas that QPainter
/// computes for a path (within 5 of 255), added contour by contour. QPainter searches all previous
/// edges in a row of pixels for each new edge, so its time grows with the square of the edges. Here
/// the time grows with the length of the contours.
class Coverage {
public:
    /// Sums over these pixels; contours are in device pixels.
    explicit Coverage(const QRect& pixels);

    /// Adds an area bounded by these points and the line from the last to the first.
    void add(std::span<const QPointF> contour);

    /// The pixels in one colour, with their coverage as opacity.
    QImage coloured(FillRule rule, const Colour& colour) const;

private:
    void addEdge(const QPointF& a, const QPointF& b);
    void addToRow(int row, double x0, double x1, double height);

    QRect pixels_;
    std::size_t stride_;
    std::vector<float>
        sums_; ///< in each pixel, how much its cover differs from its left neighbour's
};

/// QPainter is fast for fewer points than these, whatever they cross.
constexpr std::size_t fewPoints = 128;

/// Whether this summation takes less time than QPainter for an area whose edges rise and fall by
/// `height` device pixels in total.
bool worthSumming(double height, const QRect& pixels);

} // namespace app
