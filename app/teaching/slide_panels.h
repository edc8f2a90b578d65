// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_colours.h"
#include "app/teaching/walk.h"

#include <QFont>
#include <QRectF>

class QPainter;

// What stands beside the picture on a slide. Each is painted from the top of its area and returns
// how far down it came.

namespace app {

/// The fonts of a slide, with pixel sizes.
struct SlideFonts {
    QFont body; ///< 20
    QFont code;
};
SlideFonts slideFonts();
QFont sized(QFont font, double factor);
QFont bold(QFont font);

/// The pseudo-code with the step's line lit, and as many lines around it as there is room for. Long
/// lines are broken, never cut.
double paintCode(QPainter& painter, const QRectF& area, const Walk& walk, std::size_t step,
                 const FigureColours& colours);
/// The variables with the changed ones lit; where there is no room for all, those first.
double paintVariables(QPainter& painter, const QRectF& area, const Moment& moment,
                      const FigureColours& colours);
/// How many operations there were until now, of how many.
double paintOperations(QPainter& painter, const QRectF& area, const Walk& walk, std::size_t step,
                       const FigureColours& colours);

} // namespace app
