// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_paint.h"

#include "app/base/numbers.h"
#include "app/charts/figure_paint.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

struct Canvas {
    QPainter& painter;
    const Chart& chart;
    const ChartLook& look;
    const ChartLayout& layout;

    void text(const QRectF& area, int flags, const QFont& font, const QColor& colour,
              const QString& words) const
    {
        painter.setFont(font);
        painter.setPen(colour);
        painter.drawText(area, flags, words);
    }
    /// Paints text on one line, shortened with "…" if there is no room.
    void line(const QRectF& area, int alignment, const QFont& font, const QColor& colour,
              const QString& words) const
    {
        text(area, alignment | Qt::AlignVCenter | Qt::TextSingleLine, font, colour,
             QFontMetricsF(font).elidedText(words, Qt::ElideRight, area.width() + 1));
    }
};

QColor colourOf(const ChartRow& row, const ChartLook& look)
{
    return row.variant.algorithm ? algorithmColour(*row.variant.algorithm, look.ground) : look.text;
}

/// A rectangle of a text's height around a line.
QRectF around(double left, double right, double middle, double unit)
{
    return {left, middle - 10 * unit, right - left, 20 * unit};
}

void paintSymbol(const Canvas& c, const QRectF& area, const LegendBar& bar)
{
    const double height = 10 * c.layout.unit;
    paintBar(c.painter, {area.left(), area.center().y() - height / 2, area.width(), height},
             {bar.pattern, bar.form, c.look.muted}, c.layout.unit);
}

void paintSymbol(const Canvas& c, const QRectF& area, const LegendMark&)
{
    const double size = 12 * c.layout.unit;
    QPainterPath disc;
    disc.addEllipse(QPointF(), 0.9, 0.9);
    paintMarker(c.painter, {area.left(), area.center().y() - size / 2, size, size}, disc,
                clipping::Form::Published, c.look.muted);
}

void paintSymbol(const Canvas& c, const QRectF& area, const LegendBox&)
{
    const double height = 10 * c.layout.unit;
    paintBoxSymbol(c.painter, {area.left(), area.center().y() - height / 2, area.width(), height},
                   c.look.muted, c.layout.unit);
}

void paintHead(const Canvas& c)
{
    const QFont caption = captionFont(c.look);
    c.text(c.layout.title, Qt::TextWordWrap, semiBoldFont(c.look), c.look.text, c.chart.title);
    c.text(c.layout.subtitle, Qt::TextWordWrap, caption, c.look.muted, c.chart.subtitle);
    for (std::size_t i = 0; i < c.chart.legend.size(); ++i) {
        const auto& place = c.layout.legend[i];
        std::visit([&](const auto& symbol) { paintSymbol(c, place.symbol, symbol); },
                   c.chart.legend[i].symbol);
        c.text(place.text, Qt::TextWordWrap | Qt::AlignVCenter, caption, c.look.muted,
               c.chart.legend[i].text);
    }
}

void paintHeadings(const Canvas& c)
{
    const QFont caption = captionFont(c.look);
    const QRectF& lines = c.layout.headings;
    for (std::size_t p = 0; p < c.chart.panels.size(); ++p) {
        c.text({c.layout.panels[p].left(), lines.top(), c.layout.headingWidth, lines.height()},
               Qt::AlignLeft | Qt::AlignBottom | Qt::TextWordWrap, caption, c.look.muted,
               c.chart.panels[p].heading);
    }
    for (std::size_t i = 0; i < c.layout.columnRights.size(); ++i)
        c.text({lines.left(), lines.top(), c.layout.columnRights[i] - lines.left(), lines.height()},
               Qt::AlignRight | Qt::AlignBottom, caption, c.look.muted,
               c.chart.columns[qsizetype(i)]);
}

void paintAxis(const Canvas& c, std::size_t p)
{
    const double u = c.layout.unit;
    const QRectF &panel = c.layout.panels[p], &line = c.layout.ticks;
    const Axis& axis = c.layout.axes[p];
    for (const double tick : axis.ticks) {
        const double x = c.layout.x(p, tick);
        c.painter.setRenderHint(QPainter::Antialiasing, false); // one sharp pixel
        c.painter.setPen(QPen(c.look.rule, u));
        c.painter.drawLine(QPointF(x, panel.top()), QPointF(x, panel.bottom()));
        c.painter.setRenderHint(QPainter::Antialiasing);
        const Interval label = tickLabel(c.layout, p, tick, c.look);
        c.text({label.low - u, line.top(), label.high - label.low + 2 * u, line.height()},
               Qt::AlignHCenter, captionFont(c.look), c.look.muted,
               numberText(tick, axis.decimals));
    }
}

void paintUnit(const Canvas& c, std::size_t p)
{
    const std::size_t last = c.chart.oneScale ? c.layout.panels.size() - 1 : p;
    const double left = c.layout.panels[p].left(), right = c.layout.panels[last].right(),
                 middle = (left + right) / 2, half = std::max((right - left) / 2, 300.0);
    c.text({middle - half, c.layout.units.top(), 2 * half, c.layout.units.height()},
           Qt::AlignHCenter, captionFont(c.look), c.look.muted, c.chart.panels[p].unit);
}

void paintFrame(const Canvas& c)
{
    paintHead(c);
    paintHeadings(c);
    for (std::size_t p = 0; p < c.layout.panels.size(); ++p) {
        paintAxis(c, p);
        if (p == 0 || !c.chart.oneScale)
            paintUnit(c, p);
    }
    c.text(c.layout.sentences, Qt::TextWordWrap, captionFont(c.look), c.look.muted,
           sentencesOf(c.chart).join(u'\n'));
}

void paintReference(const Canvas& c)
{
    if (!c.chart.reference)
        return;
    QPen pen(c.look.muted, 1.2 * c.layout.unit, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({2, 2.5});
    c.painter.setPen(pen);
    for (std::size_t p = 0; p < c.layout.panels.size(); ++p) {
        const double x = c.layout.x(p, *c.chart.reference);
        c.painter.drawLine(QPointF(x, c.layout.panels[p].top()),
                           QPointF(x, c.layout.panels[p].bottom()));
    }
}

void paintNames(const Canvas& c, const ChartRow& row, double middle)
{
    const double u = c.layout.unit, left = c.layout.rows.front().left();
    if (row.variant.algorithm)
        paintMarker(c.painter, {left, middle - 6 * u, 12 * u, 12 * u}, row.variant, c.look.ground);
    const QFont bold = semiBoldFont(c.look), caption = captionFont(c.look);
    c.line(around(c.layout.nameLeft, c.layout.nameRight, middle, u), Qt::AlignLeft, bold,
           c.look.text, row.name);
    const double end = c.layout.nameLeft + QFontMetricsF(bold).horizontalAdvance(row.name) + 6 * u;
    if (c.layout.notes && end < c.layout.nameRight)
        c.line(around(end, c.layout.nameRight, middle, u), Qt::AlignLeft, caption, c.look.muted,
               row.note);
    if (c.layout.values)
        c.line(around(c.layout.nameRight, c.layout.valueRight, middle, u), Qt::AlignRight, caption,
               c.look.muted, row.value);
}

/// Paints the hollow marker in its own lane, on a dotted line.
void paintOther(const Canvas& c, const ChartRow& row, double top)
{
    if (!row.other)
        return;
    const double u = c.layout.unit, y = top + c.layout.laneMiddle, x = c.layout.x(0, *row.other),
                 size = 11 * u;
    QPen pen(c.look.muted, u, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({1, 3});
    c.painter.setPen(pen);
    c.painter.drawLine(QPointF(c.layout.panels.front().left(), y),
                       QPointF(x - size / 2 - 2 * u, y));
    const QRectF box(x - size / 2, y - size / 2, size, size);
    if (row.variant.algorithm)
        paintMarker(c.painter, box, {row.variant.algorithm, clipping::Form::Published},
                    c.look.ground);
}

void paintRow(const Canvas& c, std::size_t r)
{
    const ChartRow& row = c.chart.rows[r];
    const double middle = c.layout.rows[r].top() + c.layout.barMiddle;
    paintNames(c, row, middle);
    for (std::size_t p = 0; p < row.figures.size(); ++p)
        paintFigure(c.painter,
                    {c.layout, c.look, p, middle, colourOf(row, c.look), row.variant.form},
                    row.figures[p]);
    paintOther(c, row, c.layout.rows[r].top());
    for (std::size_t i = 0; i < c.layout.columnRights.size(); ++i)
        if (qsizetype(i) < row.numbers.size())
            c.line(around(c.layout.panels.back().right(), c.layout.columnRights[i], middle,
                          c.layout.unit),
                   Qt::AlignRight, captionFont(c.look), i == 0 ? c.look.text : c.look.muted,
                   row.numbers[qsizetype(i)]);
}

/// Paints a line beside all rows of the group, with a tick to each member.
void paintGroup(const Canvas& c, std::size_t g)
{
    const RowGroup& group = c.chart.groups[g];
    const double u = c.layout.unit,
                 left = c.layout.bracket + double(c.layout.lanes[g]) * c.layout.bracketLane,
                 right = left + 5 * u, reach = c.layout.thickness / 2;
    const auto middle = [&](std::size_t row) {
        return c.layout.rows[row].top() + c.layout.barMiddle;
    };
    const double top = middle(group.rows.front()) - reach,
                 bottom = middle(group.rows.back()) + reach;
    c.painter.setPen(QPen(c.look.muted, 1.2 * u, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const QPointF corners[] = {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
    c.painter.drawPolyline(corners, 4);
    for (const std::size_t row : std::span(group.rows).subspan(1, group.rows.size() - 2))
        c.painter.drawLine(QPointF(left, middle(row)), QPointF(right, middle(row)));
    c.line(around(right + 4 * u, right + 100 * u, (top + bottom) / 2, u), Qt::AlignLeft,
           captionFont(c.look), c.look.muted, group.letter);
}

} // namespace

void paint(QPainter& painter, const QRectF& area, const Chart& chart, const ChartLook& look)
{
    const ChartLayout layout = layoutOf(chart, area, look);
    const Canvas canvas{painter, chart, look, layout};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintFrame(canvas);
    for (std::size_t r = 0; r < chart.rows.size(); ++r)
        paintRow(canvas, r);
    paintReference(canvas);
    for (std::size_t g = 0; g < chart.groups.size(); ++g)
        paintGroup(canvas, g);
    painter.restore();
}

std::optional<std::size_t> rowAt(const QPointF& point, const QRectF& area, const Chart& chart,
                                 const ChartLook& look)
{
    const ChartLayout layout = layoutOf(chart, area, look);
    const auto row = std::ranges::find_if(layout.rows, [&](const QRectF& r) {
        return r.top() <= point.y() && point.y() < r.bottom();
    });
    if (row == layout.rows.end() || point.x() < area.left() || point.x() > area.right())
        return std::nullopt;
    return std::size_t(row - layout.rows.begin());
}

} // namespace app
