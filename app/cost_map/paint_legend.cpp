// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/cost_map/paint.h"
#include "app/cost_map/words.h"
#include "app/view/visible_colour.h"

#include <QFontMetricsF>
#include <QPainter>

#include <bit>
#include <cmath>

namespace app {

namespace {

constexpr double barHeight = 12, gap = 6, markerSize = 12, betweenEntries = 18;

QString shareText(const CostMap& map, const CostLegend::Share& share)
{
    return Text::tr("%1  %2", "algorithms, and their share of the map")
        .arg(namesOf(map.plan, share.cheapest),
             percentText(double(share.cells) / double(map.values.size())));
}

/// The positions of a cheapest map's legend entries, in filled lines.
struct Flow {
    std::vector<QPointF> places;
    double height = 0;
};

double markersWidth(std::uint32_t cheapest) { return std::popcount(cheapest) * (markerSize + 3.); }

Flow flowOf(const CostMap& map, const CostLegend& legend, double width,
            const QFontMetricsF& metrics)
{
    Flow flow;
    const double line = metrics.height() + 2;
    QPointF at;
    for (const CostLegend::Share& share : legend.shares) {
        const double wide =
            markersWidth(share.cheapest) + gap + metrics.horizontalAdvance(shareText(map, share));
        if (at.x() > 0 && at.x() + wide > width)
            at = {0, at.y() + line};
        flow.places.push_back(at);
        at.rx() += wide + betweenEntries;
    }
    flow.height = at.y() + line;
    return flow;
}

void paintShares(QPainter& painter, const QRectF& room, const CostMap& map,
                 const CostLegend& legend, const ChartLook& look)
{
    const QFontMetricsF metrics(look.font);
    const Flow flow = flowOf(map, legend, room.width(), metrics);
    for (std::size_t entry = 0; entry < legend.shares.size(); ++entry) {
        const CostLegend::Share& share = legend.shares[entry];
        QPointF at = room.topLeft() + flow.places[entry];
        for (std::size_t i = 0; i < map.plan.variants.size(); ++i)
            if (share.cheapest >> i & 1) {
                const Variant& variant = map.plan.variants[i];
                paintMarker(painter,
                            {at + QPointF(0, (metrics.height() - markerSize) / 2),
                             QSizeF(markerSize, markerSize)},
                            variant, look.ground);
                at.rx() += markerSize + 3;
            }
        painter.setPen(look.text);
        painter.drawText(at + QPointF(gap, metrics.ascent()), shareText(map, share));
    }
}

void paintScale(QPainter& painter, const QRectF& room, const CostMap& map, const CostLegend& legend,
                const ChartLook& look)
{
    const QRectF bar(room.left(), room.top(), room.width(), barHeight);
    for (int x = 0; x < bar.width(); ++x)
        painter.fillRect(
            QRectF(bar.left() + x, bar.top(), std::min(1., bar.width() - x), barHeight),
            sequentialColour(x / bar.width(), look.ground));
    painter.setPen(look.text);
    const QFontMetricsF metrics(look.font);
    const double base = bar.bottom() + 3 + metrics.ascent();
    const double lastLeft =
        bar.right() - metrics.horizontalAdvance(costText(*map.plan.measure, legend.ticks.back()));
    double free = bar.left();
    for (const double tick : legend.ticks) {
        const double x = bar.left() + legend.shareOf(tick) * bar.width();
        const bool last = tick == legend.ticks.back();
        const QString text = last ? costText(*map.plan.measure, tick) : shortText(tick, 3);
        const double wide = metrics.horizontalAdvance(text);
        const double left = std::clamp(x - wide / 2, bar.left(), bar.right() - wide);
        painter.drawLine(QPointF(x, bar.bottom() - 4), QPointF(x, bar.bottom()));
        if (left < free || (!last && left + wide + gap > lastLeft))
            continue;
        painter.drawText(QPointF(left, base), text);
        free = left + wide + gap;
    }
}

} // namespace

double legendHeight(const CostMap& map, double width, const CostMapLook& look)
{
    const QFontMetricsF metrics(look.chart.font);
    if (map.values.empty() || map.plan.shown)
        return barHeight + 3 + metrics.height();
    return flowOf(map, legendOf(map), width, metrics).height;
}

void paintLegend(QPainter& painter, const QRectF& room, const CostMap& map, const CostMapLook& look)
{
    if (map.values.empty())
        return;
    painter.save();
    painter.setFont(look.chart.font);
    const CostLegend legend = legendOf(map);
    map.plan.shown ? paintScale(painter, room, map, legend, look.chart)
                   : paintShares(painter, room, map, legend, look.chart);
    painter.restore();
}

} // namespace app
