// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teaching.h"
#include "app/view/algorithm_mark.h"

#include <QImage>

// The figure on an algorithm's page: ![words](figure:KEY) in its markdown. It is painted from the
// library's own trace.

namespace app {

/// The figure's line (from the row of teaching.h) in the paper's window, y up.
TracedLine pageTracedLine(const clipping::Algorithm& algorithm);
/// The figure's step: the last one with the row's mark, or the last of all if there is none.
std::size_t stepOf(const PageFigure& figure, const Narration& narration);

/// The figure, `width` logical pixels wide and 9/16 of that high, with `devicePixels` device pixels
/// for each logical one; a null image if there are no steps.
QImage pageFigure(const clipping::Algorithm& algorithm, Ground ground, int width,
                  double devicePixels);
/// The same for the address "figure:KEY"; a null image if there is no such key.
QImage pageFigure(const QString& address, Ground ground, int width, double devicePixels);

} // namespace app
