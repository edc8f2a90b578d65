// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"

#include <QColor>
#include <QRectF>

#include <vector>

class QPainter;

namespace app {

/// The recent values of a number, in the height of a line of text.
struct Sparkline {
    std::vector<double> numbers; ///< the oldest first
    std::size_t places;          ///< the number of values that fit; values are aligned to the right
};

/// The y of a number in an area that spans 40 % above and below the median; numbers beyond are
/// placed on its edge.
double sparklineY(const QRectF& area, double number, double median);

/// Paints a line, a dot at the last number, and a band between the quartiles. Paints nothing
/// without numbers.
void paint(QPainter& painter, const QRectF& area, const Sparkline& line, const QColor& colour);

} // namespace app
