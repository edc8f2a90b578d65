// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart_layout.h"

class QPainter;

namespace app {

/// Where a figure is painted: its row's middle, in a panel of a layout.
struct FigurePlace {
    const ChartLayout& layout;
    const ChartLook& look;
    std::size_t panel;
    double middle;
    QColor colour; ///< the row's
    clipping::Form form;
};

void paintFigure(QPainter& painter, const FigurePlace& place, const Figure& figure);

struct BarFill {
    std::size_t pattern; ///< index into patterns()
    clipping::Form form; ///< published: hollow
    QColor colour;
};

/// A bar as it looks, in a rectangle of its own: for the legend.
void paintBar(QPainter& painter, const QRectF& area, const BarFill& fill, double unit);
/// A box without numbers: for the legend.
void paintBoxSymbol(QPainter& painter, const QRectF& area, const QColor& colour, double unit);

} // namespace app
