// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teaching.h"
#include "app/view/algorithm_mark.h"

#include <QImage>

// The figure on an algorithm's page: ![words](figure:KEY) in its markdown. The program paints it
// from the library's own trace.

namespace app {

/// The line of the figure (from the row of teaching.h) in the paper's window, y up.
Specimen pageSpecimen(const clipping::Algorithm& algorithm);
/// Its step: the last one with the row's mark; the last of all if there is none.
std::size_t stepOf(const PageFigure& figure, const Walk& walk);
/// "Step 11 of 13: End 2 lies above the window …": what stands below it; empty: an algorithm that
/// tells no step has no figure.
QString pageFigureCaption(const clipping::Algorithm& algorithm);

/// The figure, `width` logical pixels wide and 9/16 of it high, with so many device pixels for
/// each; a null image where no step is told.
QImage pageFigure(const clipping::Algorithm& algorithm, Ground ground, int width,
                  double devicePixels);
/// The same for a viewer that asks for "figure:KEY"; a null image where the key is none.
QImage pageFigure(const QString& address, Ground ground, int width, double devicePixels);

} // namespace app
