// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_layout.h"

#include <QCoreApplication>
#include <QFontMetricsF>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

/// What is shown beside the panels.
struct Shown {
    bool notes, values;
    qsizetype columns;
};

/// The widths that a chart asks for, as it is written.
struct Widths {
    double name = 0, note = 0, value = 0, end = 0, tie = 0;
    std::vector<double> columns;
};

/// The heights of a row: at ease, and at least.
struct Pitch {
    double natural, least;
};

double widest(const QFontMetricsF& metrics, const QString& text, double so)
{
    return std::max(so, metrics.horizontalAdvance(text));
}

bool hasLane(const Chart& chart)
{
    return std::ranges::any_of(chart.rows, [](const ChartRow& row) { return row.other.has_value(); });
}

Pitch pitchOf(const Chart& chart, double unit)
{
    return hasLane(chart) ? Pitch{38 * unit, 26 * unit} : Pitch{26 * unit, 17 * unit};
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
    for (qsizetype c = 0; c < chart.columns.size(); ++c)
        widths.columns.push_back(caption.horizontalAdvance(chart.columns[c]));
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
    if (!chart.ties.empty())
        widths.tie = 14 * unit + caption.horizontalAdvance(tieWord());
    return widths;
}

/// Places everything from left to right; the panels may come out with no width.
void placeAcross(ChartLayout& layout, const Chart& chart, const QRectF& area, const Widths& widths,
                 const Shown& shown)
{
    const double u = layout.unit;
    layout.notes = shown.notes;
    layout.values = shown.values;
    const bool marks =
        std::ranges::any_of(chart.rows, [](const ChartRow& row) { return row.algorithm; });
    layout.nameLeft = area.left() + (marks ? 20 * u : 0);
    const double name = shown.notes ? std::max(widths.name, widths.note) : widths.name;
    layout.nameRight = layout.nameLeft + std::min(name, area.width() * 0.4);
    layout.valueRight =
        layout.nameRight + (shown.values && widths.value > 0 ? widths.value + 10 * u : 0);
    double right = area.right();
    layout.columnRights.assign(std::size_t(shown.columns), 0);
    for (std::size_t c = layout.columnRights.size(); c-- > 0;) {
        if (c == 0 && widths.tie > 0) {
            layout.bracket = right - widths.tie;
            right = layout.bracket - 6 * u;
        }
        layout.columnRights[c] = right;
        right -= widths.columns[c] + 16 * u;
    }
    if (shown.columns == 0 && widths.tie > 0) {
        layout.bracket = right - widths.tie;
        right = layout.bracket - 6 * u;
    }
    const double left = layout.valueRight + 8 * u, gap = 16 * u,
                 end = widths.end > 0 ? widths.end + 4 * u : 0;
    const auto count = double(chart.panels.size());
    const double width = (right - left - (count - 1) * gap) / count;
    layout.panels.clear();
    for (std::size_t p = 0; p < chart.panels.size(); ++p)
        layout.panels.emplace_back(left + double(p) * (width + gap), 0, width - end, 0);
}

void placeAcross(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const Widths widths = widthsOf(chart, look, layout.unit);
    const qsizetype all = chart.columns.size();
    const double enough = (chart.panels.size() == 1 ? 200 : 56) * layout.unit;
    for (const Shown& shown :
         {Shown{true, true, all}, Shown{false, true, all}, Shown{false, false, all},
          Shown{false, false, std::min(all, qsizetype(1))}, Shown{false, false, 0}}) {
        placeAcross(layout, chart, area, widths, shown);
        if (layout.panels.front().width() >= enough)
            return;
    }
}

/// Entries beside each other, on as many lines as it takes; where the next thing may begin.
double placeLegend(ChartLayout& layout, const Chart& chart, const QRectF& area, double top,
                   const ChartLook& look)
{
    const QFontMetricsF caption(captionFont(look));
    const double u = layout.unit, line = 20 * u;
    double x = area.left(), y = top;
    for (const LegendEntry& entry : chart.legend) {
        const double symbol = std::holds_alternative<LegendMark>(entry.symbol) ? 12 * u : 22 * u;
        const double text = caption.horizontalAdvance(entry.text) + 1,
                     width = symbol + 6 * u + text;
        if (x > area.left() && x + width > area.right()) {
            x = area.left();
            y += line;
        }
        layout.legend.push_back(
            {{x, y, symbol, line},
             {x + symbol + 6 * u, y, std::min(text, area.right() - x - symbol - 6 * u), line}});
        x += width + 18 * u;
    }
    return chart.legend.empty() ? top : y + line + 2 * u;
}

bool hasHeadings(const Chart& chart)
{
    return !chart.columns.isEmpty()
           || std::ranges::any_of(chart.panels, [](const QString& p) { return !p.isEmpty(); });
}

/// What lies above the rows; their top.
double placeHead(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const double u = layout.unit;
    double y = area.top();
    if (!chart.title.isEmpty()) {
        const double height =
            QFontMetricsF(semiBoldFont(look))
                .boundingRect(QRectF(0, 0, area.width(), 1e6), Qt::TextWordWrap, chart.title)
                .height();
        layout.title = {area.left(), y, area.width(), height};
        y += height + 3 * u;
    }
    y = placeLegend(layout, chart, area, y, look);
    if (hasHeadings(chart)) {
        layout.headings = {area.left(), y, area.width(), 20 * u};
        y = layout.headings.bottom();
    }
    return y + 4 * u;
}

/// What lies below the rows, as if they ended at 0.
void placeFoot(ChartLayout& layout, const Chart& chart, const QRectF& area, const ChartLook& look)
{
    const double u = layout.unit;
    layout.ticks = {area.left(), 5 * u, area.width(), 18 * u};
    double y = layout.ticks.bottom();
    if (!chart.unit.isEmpty()) {
        layout.unitText = {area.left(), y, area.width(), 18 * u};
        y = layout.unitText.bottom();
    }
    layout.sentences = {area.left(), y, area.width(), 0};
    if (chart.notes.isEmpty())
        return;
    const double height = QFontMetricsF(captionFont(look))
                              .boundingRect(QRectF(0, 0, area.width(), 1e6), Qt::TextWordWrap,
                                            chart.notes.join(u'\n'))
                              .height();
    layout.sentences = {area.left(), y + 6 * u, area.width(), height};
}

void placeRows(ChartLayout& layout, const Chart& chart, const QRectF& area, double top,
               double pitch)
{
    const double u = layout.unit;
    for (std::size_t r = 0; r < chart.rows.size(); ++r)
        layout.rows.emplace_back(area.left(), top + double(r) * pitch, area.width(), pitch);
    const bool lane = hasLane(chart);
    layout.thickness = std::min(lane ? pitch * 0.37 : pitch * 0.6, 15 * u);
    layout.barMiddle = lane ? pitch * 0.32 : pitch / 2;
    layout.laneMiddle = pitch * 0.74;
    const double bottom = top + double(chart.rows.size()) * pitch;
    for (QRectF& panel : layout.panels) {
        panel.setTop(top);
        panel.setBottom(bottom);
    }
    for (QRectF* below : {&layout.ticks, &layout.unitText, &layout.sentences})
        below->translate(0, bottom);
}

double unitOf(const ChartLook& look) { return look.font.pixelSize() / 13.0; }

double heightFor(const Chart& chart, double width, const ChartLook& look, double pitch)
{
    ChartLayout layout{};
    layout.unit = unitOf(look);
    const QRectF area(0, 0, width, 0);
    const double top = placeHead(layout, chart, area, look);
    placeFoot(layout, chart, area, look);
    return top + double(chart.rows.size()) * pitch + layout.sentences.bottom();
}

} // namespace

double ChartLayout::x(std::size_t panel, double value) const
{
    const QRectF& p = panels[panel];
    return p.left() + p.width() * (value - axis.range.low) / (axis.range.high - axis.range.low);
}

ChartLayout layoutOf(const Chart& chart, const QRectF& area, const ChartLook& look)
{
    ChartLayout layout{};
    layout.unit = unitOf(look);
    placeAcross(layout, chart, area, look);
    const double top = placeHead(layout, chart, area, look);
    placeFoot(layout, chart, area, look);
    const Pitch pitch = pitchOf(chart, layout.unit);
    const double room = area.bottom() - top - layout.sentences.bottom(),
                 count = std::max(double(chart.rows.size()), 1.0);
    placeRows(layout, chart, area, top,
              std::clamp(room / count, pitch.least, pitch.natural * 1.15));
    layout.axis = axisOf(chart, int(layout.panels.front().width() / (54 * layout.unit)));
    return layout;
}

double naturalHeight(const Chart& chart, double width, const ChartLook& look)
{
    return heightFor(chart, width, look, pitchOf(chart, unitOf(look)).natural);
}

double leastHeight(const Chart& chart, double width, const ChartLook& look)
{
    return heightFor(chart, width, look, pitchOf(chart, unitOf(look)).least);
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

QString tieWord() { return QCoreApplication::translate("Charts", "tie"); }

} // namespace app
