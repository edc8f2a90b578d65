// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_layout.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/experiment/record.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace app {
namespace {

/// The optional parts beside the panels that are shown.
struct Shown {
    bool notes, values;
    qsizetype columns;
};

/// The natural widths of a chart's parts.
struct Widths {
    double name = 0, note = 0, value = 0, end = 0;
    double lane = 0; ///< of brackets, with their letters
    std::vector<double> columns;
};

constexpr double squeezed = 0.67; // least share of a row's natural height

double unitOf(const ChartLook& look) { return look.font.pixelSize() / 13.0; }

double widest(const QFontMetricsF& metrics, const QString& text, double so)
{
    return std::max(so, metrics.horizontalAdvance(text));
}

/// A row with a marker below its bar is taller.
double naturalHeight(const ChartRow& row, double unit) { return (row.other ? 38 : 26) * unit; }

double naturalHeight(const Chart& chart, double unit)
{
    return std::accumulate(
        chart.rows.begin(), chart.rows.end(), 0.0,
        [unit](double sum, const ChartRow& row) { return sum + naturalHeight(row, unit); });
}

double wrappedHeight(const QFont& font, const QString& text, double width)
{
    return text.isEmpty() ? 0
                          : QFontMetricsF(font)
                                .boundingRect(QRectF(0, 0, width, 1e6), Qt::TextWordWrap, text)
                                .height();
}

double endTextWidth(const QFontMetricsF& metrics, const ChartRow& row)
{
    double width = 0;
    for (const Figure& figure : row.figures)
        if (const Bar* bar = std::get_if<Bar>(&figure); bar && !bar->text.isEmpty())
            width = widest(metrics, bar->text, width);
    return width;
}

Widths widthsOf(const Chart& chart, const ChartLook& look, double unit)
{
    const QFontMetricsF bold(semiBoldFont(look)), caption(captionFont(look));
    Widths widths;
    for (const QString& column : chart.columns)
        widths.columns.push_back(caption.horizontalAdvance(column));
    for (const ChartRow& row : chart.rows) {
        const double name = bold.horizontalAdvance(row.name);
        widths.name = std::max(widths.name, name);
        if (!row.note.isEmpty())
            widths.note =
                std::max(widths.note, name + 6 * unit + caption.horizontalAdvance(row.note));
        widths.value = widest(caption, row.value, widths.value);
        widths.end = std::max(widths.end, endTextWidth(caption, row));
        for (std::size_t c = 0; c < widths.columns.size() && qsizetype(c) < row.numbers.size(); ++c)
            widths.columns[c] = widest(caption, row.numbers[qsizetype(c)], widths.columns[c]);
    }
    for (const RowGroup& group : chart.groups)
        widths.lane = widest(caption, group.letter, widths.lane - 14 * unit) + 14 * unit;
    return widths;
}

/// The first lane for each bracket that no other bracket occupies at its rows.
std::vector<std::size_t> lanesOf(const std::vector<RowGroup>& groups)
{
    std::vector<std::size_t> lanes;
    for (const RowGroup& group : groups) {
        const auto taken = [&](std::size_t lane) {
            for (std::size_t t = 0; t < lanes.size(); ++t)
                if (lanes[t] == lane && groups[t].rows.front() <= group.rows.back()
                    && group.rows.front() <= groups[t].rows.back())
                    return true;
            return false;
        };
        std::size_t lane = 0;
        while (taken(lane))
            ++lane;
        lanes.push_back(lane);
    }
    return lanes;
}

/// Places everything to the left of the panels; returns the panels' left edge.
double placeNames(ChartLayout& layout, const Chart& chart, const QRectF& area, const Widths& widths,
                  const Shown& shown)
{
    const double u = layout.unit;
    layout.notes = shown.notes;
    layout.values = shown.values;
    const bool marks =
        std::ranges::any_of(chart.rows, [](const ChartRow& row) { return row.variant.algorithm; });
    layout.nameLeft = area.left() + (marks ? 20 * u : 0);
    const double name = shown.notes ? std::max(widths.name, widths.note) : widths.name;
    layout.nameRight = layout.nameLeft + std::min(name + 1, area.width() * 0.4);
    const bool values = shown.values && widths.value > 0;
    layout.valueRight = layout.nameRight + (values ? widths.value + 10 * u : 0);
    return std::round(layout.valueRight + 8 * u);
}

/// Places everything to the right of the panels, brackets after the first column; returns the
/// panels' right edge.
double placeColumns(ChartLayout& layout, const QRectF& area, const Widths& widths,
                    const Shown& shown)
{
    const double u = layout.unit;
    double right = area.right();
    layout.columnRights.assign(std::size_t(shown.columns), 0);
    for (auto c = std::size_t(shown.columns); c-- > 1;) {
        layout.columnRights[c] = right;
        right -= widths.columns[c] + 16 * u;
    }
    if (!layout.lanes.empty()) {
        const double lanes = double(std::ranges::max(layout.lanes) + 1);
        layout.bracketLane = widths.lane;
        layout.bracket = right - lanes * widths.lane;
        right = layout.bracket - 6 * u;
    }
    if (shown.columns > 0) {
        layout.columnRights[0] = right;
        right -= widths.columns[0] + 16 * u;
    }
    return right;
}

void placeAcross(ChartLayout& layout, const Chart& chart, const QRectF& area, const Widths& widths,
                 const Shown& shown)
{
    const double u = layout.unit, left = placeNames(layout, chart, area, widths, shown),
                 right = placeColumns(layout, area, widths, shown), gap = 16 * u,
                 end = widths.end > 0 ? widths.end + 4 * u : 0;
    const auto count = double(chart.panels.size());
    const double width = (right - left - (count - 1) * gap) / count;
    layout.headingWidth = width + gap / 2;
    layout.panels.clear();
    for (std::size_t p = 0; p < chart.panels.size(); ++p)
        layout.panels.emplace_back(left + double(p) * (width + gap), 0, std::max(width - end, 1.0),
                                   0);
}

/// Leaves out as few parts as the panels' least width allows.
void placeAcross(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const Widths widths = widthsOf(chart, look, layout.unit);
    layout.lanes = lanesOf(chart.groups);
    const qsizetype all = chart.columns.size(), one = std::min(all, qsizetype(1));
    const double enough = (chart.panels.size() == 1 ? 190 : 56) * layout.unit;
    for (const Shown& shown :
         {Shown{true, true, all}, Shown{false, true, all}, Shown{false, false, all},
          Shown{false, false, one}, Shown{false, false, 0}}) {
        placeAcross(layout, chart, area, widths, shown);
        if (layout.panels.front().width() >= enough)
            return;
    }
}

/// Places the entries side by side, on as many lines as needed; returns where the next part may
/// begin.
double placeLegend(ChartLayout& layout, const Chart& chart, const QRectF& area, double top,
                   const ChartLook& look)
{
    const QFont caption = captionFont(look);
    const double u = layout.unit, line = 20 * u;
    double x = area.left(), y = top, height = line;
    for (const LegendEntry& entry : chart.legend) {
        const double symbol =
            (std::holds_alternative<LegendMark>(entry.symbol) ? 12 : 22) * u + 6 * u;
        const double text = QFontMetricsF(caption).horizontalAdvance(entry.text) + 1;
        if (x > area.left() && x + symbol + text > area.right()) {
            x = area.left();
            y += height;
        }
        const double room = std::min(text, area.right() - x - symbol);
        height = std::max(line, wrappedHeight(caption, entry.text, room) + 4 * u);
        layout.legend.push_back({{x, y, symbol - 6 * u, line}, {x + symbol, y, room, height}});
        x += symbol + text + 18 * u;
    }
    return chart.legend.empty() ? top : y + height + 2 * u;
}

double headingsHeight(const ChartLayout& layout, const Chart& chart, const ChartLook& look)
{
    double height = layout.columnRights.empty() ? 0 : 18 * layout.unit;
    for (const Panel& panel : chart.panels)
        height =
            std::max(height, wrappedHeight(captionFont(look), panel.heading, layout.headingWidth));
    return height;
}

/// Places everything above the rows; returns the rows' top.
double placeHead(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const double u = layout.unit, width = area.width();
    double y = area.top();
    if (!chart.title.isEmpty()) {
        layout.title = {area.left(), y, width,
                        wrappedHeight(semiBoldFont(look), chart.title, width)};
        y = layout.title.bottom() + 1 * u;
    }
    if (!chart.subtitle.isEmpty()) {
        layout.subtitle = {area.left(), y, width,
                           wrappedHeight(captionFont(look), chart.subtitle, width)};
        y = layout.subtitle.bottom();
    }
    y = placeLegend(layout, chart, area, y + 3 * u, look);
    if (chart.legend.empty())
        y += 6 * u;
    layout.headings = {area.left(), y, width, headingsHeight(layout, chart, look)};
    return std::ceil(layout.headings.bottom() + 4 * u);
}

/// Places everything below the rows, as if the rows ended at 0.
void placeFoot(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const double u = layout.unit;
    const bool units =
        std::ranges::any_of(chart.panels, [](const Panel& p) { return !p.unit.isEmpty(); });
    layout.ticks = {area.left(), 4 * u, area.width(), 18 * u};
    layout.units = {area.left(), layout.ticks.bottom(), area.width(), units ? 18 * u : 0};
    const double height =
        wrappedHeight(captionFont(look), sentencesOf(chart).join(u'\n'), area.width());
    layout.sentences = {area.left(), layout.units.bottom() + (height > 0 ? 6 * u : 0), area.width(),
                        height};
}

void placeRows(ChartLayout& layout, const Chart& chart, const QRectF& area, double top,
               double stretch)
{
    const double u = layout.unit;
    double y = top;
    for (const ChartRow& row : chart.rows) { // on whole pixels, for sharp edges
        const double next = std::round(y + naturalHeight(row, u) * stretch);
        layout.rows.emplace_back(area.left(), y, area.width(), next - y);
        y = next;
    }
    layout.thickness = 2 * std::round(7 * u * std::min(stretch, 1.1));
    layout.barMiddle = std::round(13 * u * stretch);
    layout.laneMiddle = layout.barMiddle + layout.thickness / 2 + 9 * u * stretch;
    for (QRectF& panel : layout.panels) {
        panel.setTop(top);
        panel.setBottom(y);
    }
    for (QRectF* below : {&layout.ticks, &layout.units, &layout.sentences})
        below->translate(0, y);
}

/// An axis with as many ticks as there is room for their numbers.
Axis readableAxis(const ChartLayout& layout, const Chart& chart, std::size_t panel,
                  const ChartLook& look)
{
    const QFontMetricsF caption(captionFont(look));
    const double width = layout.panels[panel].width(), gap = 12 * layout.unit;
    constexpr double most = 7; // more ticks would not help
    const double marks = std::min(width / (46 * layout.unit), most);
    const Axis axis = axisOf(chart, panel, marks);
    double label = 0;
    for (const double tick : axis.ticks)
        label = widest(caption, numberText(tick, axis.decimals), label);
    return marks * (label + gap) > width ? axisOf(chart, panel, width / (label + gap)) : axis;
}

double heightFor(const Chart& chart, double width, const ChartLook& look, double stretch)
{
    ChartLayout layout{};
    layout.unit = unitOf(look);
    const QRectF area(0, 0, width, 0);
    placeAcross(layout, chart, area, look);
    const double top = placeHead(layout, chart, area, look);
    placeFoot(layout, chart, area, look);
    placeRows(layout, chart, area, top, stretch);
    return std::ceil(layout.bottom());
}

} // namespace

double ChartLayout::x(std::size_t panel, double value) const
{
    const QRectF& p = panels[panel];
    const Interval& range = axes[panel].range;
    return p.left() + p.width() * (value - range.low) / (range.high - range.low);
}

ChartLayout layoutOf(const Chart& chart, const QRectF& area, const ChartLook& look)
{
    ChartLayout layout{};
    layout.unit = unitOf(look);
    placeAcross(layout, chart, area, look);
    const double top = placeHead(layout, chart, area, look);
    placeFoot(layout, chart, area, look);
    const double room = area.bottom() - top - layout.sentences.bottom(),
                 natural = std::max(naturalHeight(chart, layout.unit), 1.0);
    placeRows(layout, chart, area, top, std::clamp(room / natural, squeezed, 1.15));
    for (std::size_t p = 0; p < chart.panels.size(); ++p)
        layout.axes.push_back(readableAxis(layout, chart, p, look));
    return layout;
}

QStringList sentencesOf(const Chart& chart)
{
    QStringList sentences = chart.notes;
    if (isBroken(chart))
        sentences << Text::tr("A bar with a gap is longer than the axis.");
    return sentences;
}

double naturalHeight(const Chart& chart, double width, const ChartLook& look)
{
    return heightFor(chart, width, look, 1);
}

double leastHeight(const Chart& chart, double width, const ChartLook& look)
{
    return heightFor(chart, width, look, squeezed);
}

QFont semiBoldFont(const ChartLook& look)
{
    QFont font = look.font;
    font.setWeight(QFont::DemiBold);
    return font;
}

QFont captionFont(const ChartLook& look)
{
    QFont font = look.font;
    font.setPixelSize(int(std::lround(font.pixelSize() * 0.92)));
    return font;
}

Interval tickLabel(const ChartLayout& layout, std::size_t panel, double tick, const ChartLook& look)
{
    const double half = QFontMetricsF(captionFont(look))
                            .horizontalAdvance(numberText(tick, layout.axes[panel].decimals))
                        / 2;
    double middle = layout.x(panel, tick);
    if (const double beyond = 5 * layout.unit; panel > 0)
        middle = std::max(middle, layout.panels[panel].left() - beyond + half);
    if (const double beyond = 5 * layout.unit; panel + 1 < layout.panels.size())
        middle = std::min(middle, layout.panels[panel].right() + beyond - half);
    return {middle - half, middle + half};
}

} // namespace app
