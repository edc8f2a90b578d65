// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart_layout.h"

class QPainter;

namespace app {

/// The place of a figure: the middle of its row, in a panel of a layout.
struct FigurePlace {
    const ChartLayout& layout;
    const ChartLook& look;
    std::size_t panel;
    double middle;
    QColor colour; ///< the row's colour
    clipping::Form form;
};

void paintFigure(QPainter& painter, const FigurePlace& place, const Figure& figure);

struct BarFill {
    std::size_t pattern; ///< index into patterns()
    clipping::Form form; ///< published: hollow
    QColor colour;
};

/// Paints a bar that fills a rectangle: for the legend.
void paintBar(QPainter& painter, const QRectF& area, const BarFill& fill, double unit);
/// Paints a box without numbers: for the legend.
void paintBoxSymbol(QPainter& painter, const QRectF& area, const QColor& colour, double unit);

} // namespace app
