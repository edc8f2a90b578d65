// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"

#include <QColor>
#include <QRectF>

#include <vector>

class QPainter;

namespace app {

/// How a number went lately, in the height of a line of text.
struct Sparkline {
    std::vector<double> numbers; ///< the oldest first
    std::size_t places;          ///< how many there is room for: they stand at the right end
};

/// Where a number is in an area that shows 40 % above and below the median; what is farther off
/// lies on its edge.
double sparklineY(const QRectF& area, double number, double median);

/// A line, a dot at the last number, and a band between the quartiles. Nothing without numbers.
void paint(QPainter& painter, const QRectF& area, const Sparkline& line, const QColor& colour);

} // namespace app
