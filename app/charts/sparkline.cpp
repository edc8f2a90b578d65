// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/sparkline.h"

#include "app/charts/chart.h"

#include <QPainter>

#include <algorithm>

namespace app {

namespace {

constexpr double dot = 2.25; // radius, pixels

/// The points of the line, the last one `dot` before the right edge.
QPolygonF pointsOf(const QRectF& area, const Sparkline& line, double median)
{
    const std::size_t places = std::max({line.places, line.numbers.size(), std::size_t(2)});
    const double right = area.right() - dot, step = (area.width() - 2 * dot) / double(places - 1);
    QPolygonF points;
    for (std::size_t i = 0; i < line.numbers.size(); ++i)
        points << QPointF(right - step * double(line.numbers.size() - 1 - i),
                          sparklineY(area, line.numbers[i], median));
    return points;
}

} // namespace

double sparklineY(const QRectF& area, double number, double median)
{
    constexpr double reach = 0.4;
    const double off = median > 0 ? (number / median - 1) / reach : 0,
                 half = area.height() / 2 - dot;
    return area.center().y() - std::clamp(off, -1.0, 1.0) * half;
}

void paint(QPainter& painter, const QRectF& area, const Sparkline& line, const QColor& colour)
{
    if (line.numbers.empty())
        return;
    const Box box = boxOf(line.numbers);
    const QPolygonF points = pointsOf(area, line, box.median);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    QColor band = colour;
    band.setAlphaF(0.16F);
    const double top = sparklineY(area, box.quartiles.high, box.median),
                 bottom = sparklineY(area, box.quartiles.low, box.median);
    painter.fillRect(QRectF(points.front().x(), top, points.back().x() - points.front().x(),
                            std::max(bottom - top, 1.0)),
                     band);
    painter.setPen(QPen(colour, 1.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(points);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawEllipse(points.back(), dot, dot);
    painter.restore();
}

} // namespace app
