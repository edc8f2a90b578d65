// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"
#include "app/base/variant.h"

#include <QStringList>

#include <variant>

namespace app {

// A chart as plain data: a row a variant, from the top down, with bars or boxes in one panel or
// in several side by side. chart_paint.h paints it, chart_file.h writes it.

/// A bar from zero, of parts one after the other. The n-th part has the n-th pattern
/// (pattern.h); the first is solid.
struct Bar {
    std::vector<double> parts;
    std::optional<Interval> whiskers{}; ///< where its end lies with 95 % confidence
    QString text{};                     ///< at its end
    double length() const;
};

/// Many measurements of one thing: quartiles, the median, and the outliers one by one. Whiskers go
/// to the last number that is within 1.5 times the quartiles' distance of its quartile.
struct Box {
    Interval whiskers, quartiles;
    double median;
    std::vector<double> outliers{};
};
Box boxOf(std::span<const double> numbers); ///< of at least one, all finite

/// Nothing where there is no such number.
using Figure = std::variant<std::monostate, Bar, Box>;

struct ChartRow {
    Variant variant{}; ///< colour and marker, hollow if published; no algorithm: text's, and none
    QString name;      ///< "CS"
    QString note{};                ///< "as published"; left out where space is short
    QString value{};               ///< "23.9 ns", left of the panel
    std::vector<Figure> figures;   ///< one a panel
    std::optional<double> other{}; ///< what the bar is compared with: a hollow marker below it
    QStringList numbers{};         ///< one a column
    QString detail{};              ///< all that is known of it, a line a fact: shown on hover
};

/// Rows that do not differ significantly, each from each other, from the top down: a bracket.
struct RowGroup {
    std::vector<std::size_t> rows; ///< two at least
    QString letter{};
};

/// What the legend shows beside a text.
struct LegendBar { ///< a piece of a bar
    std::size_t pattern = 0;
    clipping::Form form = clipping::Form::Corrected;
};
struct LegendMark {}; ///< a hollow marker
struct LegendBox {};
struct LegendEntry {
    std::variant<LegendBar, LegendMark, LegendBox> symbol;
    QString text;
};

struct Panel {
    QString heading{};
    QString unit{};       ///< of its axis: "nanoseconds a line"
    bool fromZero = true; ///< boxes may leave zero out
};

struct Chart {
    QString key;        ///< of its file's name: "table1-clip"
    QString title;      ///< "Clipping only, lowest median = 1"
    QString subtitle{}; ///< "Scene “Long”, 1,000,000 lines"
    std::vector<LegendEntry> legend{};
    std::vector<Panel> panels{Panel{}}; ///< one at least
    bool oneScale = true;               ///< of all panels
    QStringList columns{};              ///< headings of the numbers at the right
    std::vector<ChartRow> rows;
    std::vector<RowGroup> groups{};    ///< a row may be in several; none holds another
    std::optional<double> reference{}; ///< a line through all rows, such as 1
    QStringList notes{};               ///< sentences below
};

/// All that it says, in words: for who cannot see it.
QString textOf(const Chart& chart);

} // namespace app
