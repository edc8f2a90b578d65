// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"
#include "app/teaching/narration.h"

#include <QFont>
#include <QRectF>

class QPainter;

// The panels beside the picture of a slide. Each is painted from the top of its area; its function
// returns the y where it ends.

namespace app {

/// The fonts of a slide, with pixel sizes.
struct SlideFonts {
    QFont body; ///< 20
    QFont code;
};
SlideFonts slideFonts();
QFont sized(QFont font, double factor);
QFont bold(QFont font);

/// Paints the pseudo-code with the step's line highlighted, and as many lines around it as there is
/// room for. Long lines are wrapped, never cut.
double paintCode(QPainter& painter, const QRectF& area, const Narration& narration,
                 std::size_t step, const FigureColours& colours);
/// Paints the variables with the changed ones highlighted; if there is no room for all, the changed
/// ones first.
double paintVariables(QPainter& painter, const QRectF& area, const NarratedStep& narrated,
                      const FigureColours& colours);
/// Paints the operations so far, and their total.
double paintOperations(QPainter& painter, const QRectF& area, const Narration& narration,
                       std::size_t step, const FigureColours& colours);

} // namespace app
