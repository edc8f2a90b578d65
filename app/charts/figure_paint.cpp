// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/figure_paint.h"

#include "app/charts/pattern.h"

#include <QPainter>

#include <algorithm>

namespace app {
namespace {

constexpr double outline = 1.5; // of hollow bars, logical pixels

QPen flatPen(const QColor& colour, double width)
{
    return {colour, width, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin};
}

void paintWhiskers(QPainter& painter, const FigurePlace& place, const Interval& whiskers,
                   double end)
{
    const double u = place.layout.unit, low = place.layout.x(place.panel, whiskers.low),
                 high = place.layout.x(place.panel, whiskers.high), y = place.middle,
                 cap = place.layout.thickness * 0.2;
    if (high - low < 4 * u)
        return; // narrower than its own ends: the end of the bar suffices
    const bool hollow = place.form == clipping::Form::Published;
    const auto line = [&](double x1, double y1, double x2, double y2, const QColor& colour) {
        painter.setPen(flatPen(colour, 1.4 * u));
        painter.drawLine(QPointF(x1, y1), QPointF(x2, y2));
    };
    const QColor &text = place.look.text, &within = hollow ? text : place.look.paper;
    line(low, y, std::max(low, end), y, within);
    line(low, y - cap, low, y + cap, low < end ? within : text);
    line(std::min(end, high), y, high, y, text);
    line(high, y - cap, high, y + cap, high <= end ? within : text);
}

/// A slanted gap near the bar's end: the bar continues beyond the axis.
void paintGap(QPainter& painter, const FigurePlace& place, double start, double end)
{
    const double u = place.layout.unit, half = place.layout.thickness / 2 + u,
                 x = end - std::min(14 * u, (end - start) * 0.4);
    painter.setPen(flatPen(place.look.paper, 3 * u));
    painter.drawLine(QPointF(x - 3 * u, place.middle + half),
                     QPointF(x + 3 * u, place.middle - half));
}

void paintEndText(QPainter& painter, const FigurePlace& place, double end, const QString& text)
{
    const double u = place.layout.unit;
    painter.setPen(place.look.text);
    painter.setFont(captionFont(place.look));
    painter.drawText(QRectF(end + 4 * u, place.middle - 10 * u, 1000 * u, 20 * u),
                     int(Qt::AlignLeft | Qt::AlignVCenter), text);
}

void paint(QPainter&, const FigurePlace&, const std::monostate&) {}

void paint(QPainter& painter, const FigurePlace& place, const Bar& bar)
{
    const ChartLayout& layout = place.layout;
    const double top = place.middle - layout.thickness / 2,
                 most = layout.axes[place.panel].range.high;
    const auto form = bar.parts.size() > 1 ? clipping::Form::Corrected : place.form;
    double from = 0;
    for (std::size_t p = 0; p < bar.parts.size(); ++p) {
        const double left = layout.x(place.panel, std::min(from, most)),
                     right = layout.x(place.panel, std::min(from + bar.parts[p], most));
        paintBar(painter, {left, top, right - left, layout.thickness}, {p, form, place.colour},
                 layout.unit);
        from += bar.parts[p];
    }
    double end = layout.x(place.panel, std::min(from, most));
    if (from > most) {
        paintGap(painter, place, layout.x(place.panel, 0), end);
    } else if (bar.whiskers) {
        paintWhiskers(painter, place, *bar.whiskers, end);
        end = std::max(end, layout.x(place.panel, bar.whiskers->high));
    }
    if (!bar.text.isEmpty())
        paintEndText(painter, place, end, bar.text);
}

void paint(QPainter& painter, const FigurePlace& place, const Box& box)
{
    const ChartLayout& layout = place.layout;
    const double u = layout.unit, y = place.middle, half = layout.thickness / 2;
    const auto x = [&](double value) { return layout.x(place.panel, value); };
    const bool hollow = place.form == clipping::Form::Published;
    painter.setPen(flatPen(place.colour, outline * u));
    painter.drawLine(QPointF(x(box.whiskers.low), y), QPointF(x(box.quartiles.low), y));
    painter.drawLine(QPointF(x(box.quartiles.high), y), QPointF(x(box.whiskers.high), y));
    for (const double end : {box.whiskers.low, box.whiskers.high})
        painter.drawLine(QPointF(x(end), y - half * 0.5), QPointF(x(end), y + half * 0.5));
    QColor fill = place.colour;
    fill.setAlphaF(hollow ? 0.0F : 0.35F);
    painter.setBrush(fill);
    const double least = 2 * u, left = x(box.quartiles.low);
    const double width = std::max(x(box.quartiles.high) - left, least);
    painter.drawRect(QRectF(left, y - half, width, 2 * half));
    painter.setPen(flatPen(place.look.text, 2 * u));
    painter.drawLine(QPointF(x(box.median), y - half), QPointF(x(box.median), y + half));
    painter.setPen(QPen(place.colour, 1.2 * u));
    painter.setBrush(Qt::NoBrush);
    for (const double outlier : box.outliers)
        painter.drawEllipse(QPointF(x(outlier), y), 2.5 * u, 2.5 * u);
}

} // namespace

void paintFigure(QPainter& painter, const FigurePlace& place, const Figure& figure)
{
    std::visit([&](const auto& f) { paint(painter, place, f); }, figure);
}

void paintBar(QPainter& painter, const QRectF& area, const BarFill& fill, double unit)
{
    const bool solid = fill.pattern == 0 && fill.form == clipping::Form::Corrected;
    if (solid || area.width() <= 2 * outline * unit) { // no room for an interior
        painter.fillRect(area, fill.colour);
        return;
    }
    if (fill.pattern > 0)
        paintPattern(painter, area, patterns()[fill.pattern % patterns().size()], fill.colour,
                     unit);
    const double inset = outline * unit / 2;
    painter.setPen(flatPen(fill.colour, outline * unit));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area.adjusted(inset, inset, -inset, -inset));
}

void paintBoxSymbol(QPainter& painter, const QRectF& area, const QColor& colour, double unit)
{
    const double y = area.center().y(), inset = area.width() / 4;
    painter.setPen(flatPen(colour, outline * unit));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.left() + inset, y));
    painter.drawLine(QPointF(area.right() - inset, y), QPointF(area.right(), y));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(area.adjusted(inset, 0, -inset, 0));
    painter.drawLine(QPointF(area.center().x(), area.top()),
                     QPointF(area.center().x(), area.bottom()));
}

} // namespace app
