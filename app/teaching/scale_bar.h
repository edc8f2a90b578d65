// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/figure_frame.h"

class QPainter;

namespace app {

/// A stretch of a round length, in a lower corner of a figure.
struct ScaleBar {
    QRectF box; ///< of everything
    QLineF line;
    QString text; ///< "2 mm"
};

/// The bar of a figure that has one (FigureFrame::hasScale); empty if there is no free place.
std::optional<ScaleBar> scaleBarOf(const TracedLine& tracedLine, const FigureFrame& frame);

void paintScaleBar(QPainter& painter, const ScaleBar& bar, const FigureFrame& frame,
                   const FigureColours& colours);

} // namespace app
