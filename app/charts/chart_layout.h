// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/axis.h"
#include "app/view/chart_look.h"

#include <QRectF>

namespace app {

/// The position of every part of a chart. If space is short, optional parts are left out: first
/// notes beside names, then values, then columns of numbers.
struct ChartLayout {
    double unit; ///< size of a logical pixel
    QRectF title, subtitle;
    struct LegendPlace {
        QRectF symbol, text;
    };
    std::vector<LegendPlace> legend; ///< one for each entry
    QRectF headings;     ///< some lines, aligned to the last one; empty if there are no headings
    double headingWidth; ///< of a panel, including the texts at the ends of its bars
    bool notes, values;  ///< whether they are shown
    double nameLeft, nameRight, valueRight;
    std::vector<QRectF> rows;         ///< over the whole width; adjacent rows touch
    double barMiddle, laneMiddle;     ///< distances from the top of a row
    double thickness;                 ///< of a bar
    std::vector<QRectF> panels;       ///< over all rows, without the texts at the ends of bars
    std::vector<double> columnRights; ///< right edges of the columns that are shown
    double bracket;                   ///< left edge of the first lane of group brackets
    double bracketLane;               ///< distance between lanes, from bracket to bracket
    std::vector<std::size_t> lanes;   ///< of each group; overlapping groups have different lanes
    QRectF ticks;                     ///< one line of text
    QRectF units;                     ///< one line of text; empty without units
    QRectF sentences;                 ///< the place of sentencesOf
    std::vector<Axis> axes;           ///< one for each panel

    double x(std::size_t panel, double value) const;
    double bottom() const { return sentences.bottom(); }
};

ChartLayout layoutOf(const Chart& chart, const QRectF& area, const ChartLook& look);

/// The chart's notes, and the notes that its layout needs.
QStringList sentencesOf(const Chart& chart);

/// The height without compression, and the least possible height.
double naturalHeight(const Chart& chart, double width, const ChartLook& look);
double leastHeight(const Chart& chart, double width, const ChartLook& look);

/// The fonts other than the body font.
QFont semiBoldFont(const ChartLook& look);
QFont captionFont(const ChartLook& look);

/// The horizontal extent of a number on an axis: below its tick, without overlap with the numbers
/// of the next panel.
Interval tickLabel(const ChartLayout& layout, std::size_t panel, double tick,
                   const ChartLook& look);

} // namespace app
