// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/scale_bar.h"

#include "app/base/numbers.h"
#include "app/teaching/edge_labels.h"

#include <QFontMetricsF>
#include <QPainter>

#include <array>
#include <cmath>

namespace app {

namespace {

/// The largest of 1, 2 and 5 times a power of ten that is not larger than a length.
double roundLength(double most)
{
    const double ten = std::pow(10, std::floor(std::log10(most)));
    for (const double times : {5.0, 2.0})
        if (times * ten <= most)
            return times * ten;
    return ten;
}

/// What the bar must not cover, the same in all steps.
LabelObstacles obstaclesOfBar(const TracedLine& tracedLine, const FigureFrame& frame)
{
    LabelObstacles obstacles{frame.picture(), {}, {}, drawnEdges(tracedLine, frame)};
    if (!frame.reserved.isEmpty())
        obstacles.boxes.push_back(frame.reserved);
    if (const auto part = frame.part(tracedLine.line)) {
        obstacles.lines.push_back(*part);
        const double r = 8 * frame.unit(); // the marks of its ends
        for (const QPointF& end : {part->p1(), part->p2()})
            obstacles.boxes.emplace_back(end - QPointF(r, r), end + QPointF(r, r));
    }
    return obstacles;
}

} // namespace

std::optional<ScaleBar> scaleBarOf(const TracedLine& tracedLine, const FigureFrame& frame)
{
    const double u = frame.unit(), longest = 84 * u, inset = 14 * u, gap = 7 * u;
    const Point half = frame.seen.max / 2.0 - frame.seen.min / 2.0;
    const double perPixel = 2 * (half.x / frame.size.width());
    if (!frame.hasScale || !(perPixel * longest > 1e-290) || !std::isfinite(perPixel * longest))
        return std::nullopt;
    const double length = roundLength(perPixel * longest);
    ScaleBar bar;
    bar.text = shortText(length);
    if (!tracedLine.unit.isEmpty())
        bar.text += u' ' + tracedLine.unit;
    const QFontMetricsF text(detailFont(frame));
    const QSizeF size(length / perPixel + gap + text.horizontalAdvance(bar.text), text.height());
    const double y = frame.size.height() - inset / 2 - size.height();
    const std::array places{QRectF({inset, y}, size),
                            QRectF({frame.size.width() - inset - size.width(), y}, size),
                            QRectF({(frame.size.width() - size.width()) / 2, y}, size)};
    const auto place = freePlace(places, obstaclesOfBar(tracedLine, frame));
    if (!place)
        return std::nullopt;
    bar.box = *place;
    const QPointF from(bar.box.left(), bar.box.center().y());
    bar.line = {from, from + QPointF(length / perPixel, 0)};
    return bar;
}

void paintScaleBar(QPainter& painter, const ScaleBar& bar, const FigureFrame& frame,
                   const FigureColours& colours)
{
    const double u = frame.unit();
    painter.setPen(QPen(colours.muted, u));
    painter.drawLine(bar.line);
    for (const QPointF& end : {bar.line.p1(), bar.line.p2()})
        painter.drawLine(end - QPointF(0, 4 * u), end + QPointF(0, 4 * u));
    const QFont font = detailFont(frame);
    painter.setFont(font);
    painter.drawText(bar.box.adjusted(bar.line.length() + 7 * u, 0, 2 * u, 0),
                     Qt::AlignLeft | Qt::AlignVCenter, bar.text);
}

} // namespace app
