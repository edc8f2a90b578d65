// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/axis.h"
#include "app/view/chart_look.h"

#include <QRectF>

namespace app {

/// Where everything of a chart is. What is told but not needed is left out where space is short:
/// first notes beside names, then values, then columns of numbers.
struct ChartLayout {
    double unit; ///< size of a logical pixel
    QRectF title, subtitle;
    struct LegendPlace {
        QRectF symbol, text;
    };
    std::vector<LegendPlace> legend; ///< one an entry
    QRectF headings;     ///< some lines, on the last of which they end; empty if there are none
    double headingWidth; ///< of a panel: over what stands at the ends of its bars too
    bool notes, values;  ///< whether they are shown
    double nameLeft, nameRight, valueRight;
    std::vector<QRectF> rows;         ///< over the whole width; they touch
    double barMiddle, laneMiddle;     ///< below the top of a row
    double thickness;                 ///< of a bar
    std::vector<QRectF> panels;       ///< over all rows, without the text at the ends of bars
    std::vector<double> columnRights; ///< of those that are shown
    double bracket;                   ///< left of the first lane of the brackets of groups
    double bracketLane;               ///< how far lanes are apart: the next bracket's left
    std::vector<std::size_t> lanes;   ///< one a group: those beside each other have their own
    QRectF ticks;                     ///< a line
    QRectF units;                     ///< a line; empty without units
    QRectF sentences;                 ///< what sentencesOf says
    std::vector<Axis> axes;           ///< one a panel

    double x(std::size_t panel, double value) const;
    double bottom() const { return sentences.bottom(); }
};

ChartLayout layoutOf(const Chart& chart, const QRectF& area, const ChartLook& look);

/// The chart's notes, and what its layout adds to them.
QStringList sentencesOf(const Chart& chart);

/// The height in which nothing is squeezed, and the least one.
double naturalHeight(const Chart& chart, double width, const ChartLook& look);
double leastHeight(const Chart& chart, double width, const ChartLook& look);

/// The fonts beside the usual one.
QFont semiBoldFont(const ChartLook& look);
QFont captionFont(const ChartLook& look);

/// From where to where a number of an axis is written: below its tick, but apart from the numbers
/// of the next panel.
Interval tickLabel(const ChartLayout& layout, std::size_t panel, double tick,
                   const ChartLook& look);

} // namespace app
