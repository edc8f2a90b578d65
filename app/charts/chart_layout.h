// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/axis.h"
#include "app/charts/chart_look.h"

#include <QRectF>

namespace app {

/// Where everything of a chart is. What is told but not needed is left out where space is short:
/// first notes beside names, then values, then columns of numbers.
struct ChartLayout {
    double unit; ///< size of a logical pixel
    QRectF title;
    struct LegendPlace {
        QRectF symbol, text;
    };
    std::vector<LegendPlace> legend; ///< one an entry
    QRectF headings;                 ///< a line; empty if nothing has a heading
    bool notes, values;              ///< whether they are shown
    double nameLeft, nameRight, valueRight;
    std::vector<QRectF> rows;     ///< over the whole width; they touch
    double barMiddle, laneMiddle; ///< below the top of a row
    double thickness;             ///< of a bar
    std::vector<QRectF> panels;   ///< over all rows, without the text at the ends of bars
    std::vector<double> columnRights;
    double bracket;   ///< left of the brackets of ties
    QRectF ticks;     ///< a line
    QRectF unitText;  ///< a line; empty without a unit
    QRectF sentences; ///< the chart's notes
    Axis axis;

    double x(std::size_t panel, double value) const;
    double bottom() const { return sentences.bottom(); }
};

ChartLayout layoutOf(const Chart& chart, const QRectF& area, const ChartLook& look);

/// The height in which nothing is squeezed, and the one below which rows overlap.
double naturalHeight(const Chart& chart, double width, const ChartLook& look);
double leastHeight(const Chart& chart, double width, const ChartLook& look);

/// The fonts beside the usual one.
QFont semiBoldFont(const ChartLook& look);
QFont captionFont(const ChartLook& look);

/// What stands at the bracket of a tie.
QString tieWord();

} // namespace app
