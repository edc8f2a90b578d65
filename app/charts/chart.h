// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/statistics.h"
#include "app/base/variant.h"

#include <QStringList>

#include <variant>

namespace app {

// A chart as plain data: a row for each variant, from the top down, with bars or boxes in one panel
// or in several side by side. chart_paint.h paints it, chart_file.h writes it.

/// A bar from zero that consists of consecutive parts. The n-th part has the n-th pattern
/// (pattern.h); the first pattern is solid.
struct Bar {
    std::vector<double> parts;
    std::optional<Interval> whiskers{}; ///< 95 % confidence interval of the bar's end
    QString text{};                     ///< at the bar's end
    double length() const;
};

/// A box plot of many measurements: quartiles, the median, and single outliers. A whisker ends at
/// the last number within 1.5 interquartile ranges of its quartile.
struct Box {
    Interval whiskers, quartiles;
    double median;
    std::vector<double> outliers{};
};
Box boxOf(std::span<const double> numbers); ///< of at least one number, all finite

/// monostate: there is no such number.
using Figure = std::variant<std::monostate, Bar, Box>;

struct ChartRow {
    Variant variant{}; ///< colour and marker (published: hollow); null: text colour, no marker
    QString name;      ///< "CS"
    QString note{};    ///< "as published"; left out if space is short
    QString value{};               ///< "23.9 ns", left of the panel
    std::vector<Figure> figures;   ///< one for each panel
    std::optional<double> other{}; ///< value to compare with: a hollow marker below the bar
    QStringList numbers{};         ///< one for each column
    QString detail{};              ///< all details, one fact per line: shown on hover
};

/// Rows of which no two differ significantly, from the top down: shown as a bracket.
struct RowGroup {
    std::vector<std::size_t> rows; ///< at least two
    QString letter{};
};

/// The symbol beside a text of the legend.
struct LegendBar { ///< a part of a bar
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
    QString unit{};       ///< of the axis: "nanoseconds a line"
    bool fromZero = true; ///< may be false only for boxes
};

struct Chart {
    QString key;        ///< part of the file's name: "table1-clip"
    QString title;      ///< "Clipping only, lowest median = 1"
    QString subtitle{}; ///< "Scene “Long”, 1,000,000 lines"
    std::vector<LegendEntry> legend{};
    std::vector<Panel> panels{Panel{}}; ///< at least one
    bool oneScale = true;               ///< the same scale in all panels
    QStringList columns{};              ///< headings of the numbers on the right
    std::vector<ChartRow> rows;
    std::vector<RowGroup> groups{};    ///< a row may be in several; none contains another
    std::optional<double> reference{}; ///< a line through all rows, e.g. at 1
    QStringList notes{};               ///< sentences below
};

/// The chart's content in words, for people who cannot see it.
QString textOf(const Chart& chart);

} // namespace app
