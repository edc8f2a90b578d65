// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QRectF>

#include <span>
#include <vector>

class QPainter;

namespace app {

/// The fill of a part of a bar, distinguishable without colour: a tint of the bar's colour, and
/// lines on it.
struct Pattern {
    double tint;                ///< opacity of the colour behind the lines
    std::vector<double> angles; ///< of the lines, degrees from the x axis; empty: no lines
    double distance = 4;        ///< between lines, in logical pixels
};

/// In the order of a bar's parts, repeated after the last.
std::span<const Pattern> patterns();

/// Fills the rectangle. The lines are clipped vector lines, so that every format keeps them. `unit`
/// is the size of a logical pixel.
void paintPattern(QPainter& painter, const QRectF& area, const Pattern& pattern,
                  const QColor& colour, double unit);

} // namespace app
