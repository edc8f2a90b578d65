// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/paint.h"

#include "app/base/numbers.h"
#include "app/cost_map/regions.h"
#include "app/cost_map/words.h"
#include "app/view/visible_colour.h"

#include <QFontMetricsF>
#include <QImage>
#include <QPainter>

#include <array>
#include <bit>
#include <cmath>
#include <functional>

namespace app {

namespace {

constexpr int stripe = 7;             // logical pixels, for a tie
constexpr double softness = 0.35;     // share of the paper's colour in an area
constexpr double leastShare = 0.0002; // of all cells: smaller regions have no label

QColor mixed(const QColor& one, const QColor& other, double share)
{
    const auto part = [&](int a, int b) { return int(std::lround(a + (b - a) * share)); };
    return {part(one.red(), other.red()), part(one.green(), other.green()),
            part(one.blue(), other.blue())};
}

/// The colours of a cell, used in turn: a tie has several.
std::vector<QRgb> stripesOf(const CostPlan& plan, std::uint32_t cheapest, const ChartLook& look)
{
    std::vector<QRgb> colours;
    for (std::size_t i = 0; i < plan.variants.size(); ++i)
        if (cheapest >> i & 1)
            colours.push_back(mixed(algorithmColour(*plan.variants[i].algorithm, look.ground),
                                    look.paper, softness)
                                  .rgb());
    return colours;
}

/// The colours of the cells of one map.
class CellColours {
public:
    CellColours(const CostMap& map, const CostMapLook& look) : map_(map), legend_(legendOf(map))
    {
        for (const CostLegend::Share& share : legend_.shares)
            stripes_.push_back(stripesOf(map.plan, share.cheapest, look.chart));
        for (std::size_t i = 0; i < scale_.size(); ++i)
            scale_[i] =
                sequentialColour(double(i) / double(scale_.size() - 1), look.chart.ground).rgb();
    }

    QRgb at(std::size_t cell, int diagonal) const
    {
        if (map_.cheapest.empty())
            return scale_[std::size_t(
                std::lround(legend_.shareOf(map_.values[cell]) * double(scale_.size() - 1)))];
        std::size_t kind = 0;
        while (legend_.shares[kind].cheapest != map_.cheapest[cell])
            ++kind;
        const auto& colours = stripes_[kind];
        return colours[std::size_t(diagonal) % colours.size()];
    }

private:
    const CostMap& map_;
    CostLegend legend_;
    std::vector<std::vector<QRgb>> stripes_;
    std::array<QRgb, 256> scale_{};
};

void paintCells(QPainter& painter, const QRectF& place, const CostMap& map, const CostMapLook& look)
{
    const double ratio = painter.device()->devicePixelRatioF();
    QImage image((place.size() * ratio).toSize().expandedTo({1, 1}), QImage::Format_ARGB32);
    image.fill(Qt::transparent);
    const CellColours paints(map, look);
    const int width = std::max(1, int(std::lround(stripe * ratio)));
    for (int y = 0; y < image.height(); ++y) {
        auto* line = reinterpret_cast<QRgb*>(image.scanLine(y));
        const int row = int(std::int64_t(y) * map.plan.rows / image.height());
        for (int x = 0; x < image.width(); ++x) {
            const int column = int(std::int64_t(x) * map.plan.columns / image.width());
            if (const std::size_t cell = map.at(column, row); cell < map.values.size())
                line[x] = paints.at(cell, (x + y) / width);
        }
    }
    painter.drawImage(place, image);
}

QString labelOf(const CostMap& map, std::size_t cell)
{
    return map.cheapest.empty() ? countText(std::size_t(map.values[cell]))
                                : namesOf(map.plan, map.cheapest[cell]);
}

/// Paints a label, with a background if it lies on stripes.
void paintLabel(QPainter& painter, const QRectF& box, const CostMap& map, std::size_t cell,
                const CostMapLook& look)
{
    QColor ground = sequentialColour(legendOf(map).shareOf(map.values[cell]), look.chart.ground);
    if (!map.cheapest.empty()) {
        const auto colours = stripesOf(map.plan, map.cheapest[cell], look.chart);
        ground = colours.size() > 1 ? look.chart.paper : QColor(colours.front());
        if (colours.size() > 1)
            painter.fillRect(box, ground);
    }
    painter.setPen(readableOn(ground));
    painter.drawText(box, Qt::AlignCenter, labelOf(map, cell));
}

void paintLabels(QPainter& painter, const QRectF& place, const CostMap& map,
                 const CostMapLook& look)
{
    painter.setFont(look.chart.font);
    const QFontMetricsF metrics(look.chart.font);
    const double cell = std::min(place.width() / map.plan.columns, place.height() / map.plan.rows);
    for (const CostRegion& region : regionsOf(map)) {
        if (double(region.cells) < leastShare * double(map.plan.cells()))
            continue;
        const std::size_t index = map.at(region.column, region.row);
        const QSizeF size(metrics.horizontalAdvance(labelOf(map, index)) + 6, metrics.height());
        if ((2 * region.reach + 1) * cell < std::max(size.width(), size.height()))
            continue;
        QRectF box(QPointF(), size);
        box.moveCenter(onMap(map.plan, place, map.plan.middleOf(region.column, region.row)));
        paintLabel(painter, box, map, index, look);
    }
}

/// Draws a line that is visible on every colour: with a rim in the ground's colour.
void outlined(QPainter& painter, const QColor& colour, const QColor& rim, double width,
              const std::function<void()>& draw)
{
    for (const auto& [c, w] : {std::pair(rim, width + 2), std::pair(colour, width)}) {
        painter.setPen(QPen(c, w, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        draw();
    }
}

void paintMarks(QPainter& painter, const QRectF& place, const CostMap& map, const CostMapLook& look)
{
    const CostPlan& plan = map.plan;
    painter.setBrush(Qt::NoBrush);
    const QRectF window(onMap(plan, place, plan.window.min), onMap(plan, place, plan.window.max));
    outlined(painter, look.window, look.chart.paper, 2, [&] { painter.drawRect(window); });
    const QPointF fixed = onMap(plan, place, plan.fixed);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(look.chart.paper, 2));
    painter.setBrush(look.chart.text);
    painter.drawEllipse(fixed, 6, 6);
    painter.setRenderHint(QPainter::Antialiasing, false);
}

} // namespace

CostMapLook costMapLook(Ground ground)
{
    return {chartLook(ground), ground == Ground::Light ? 0xC2410C : 0xFF8F52};
}

QRectF mapPlace(const CostPlan& plan, const QRectF& room)
{
    const Point extent = plan.area.max - plan.area.min;
    const QSizeF size =
        QSizeF(extent.x, extent.y).scaled(room.size(), Qt::KeepAspectRatio).expandedTo({1, 1});
    QRectF place(QPointF(), QSizeF(std::floor(size.width()), std::floor(size.height())));
    place.moveTo(room.left() + std::floor((room.width() - place.width()) / 2), room.top());
    return place;
}

QPointF onMap(const CostPlan& plan, const QRectF& place, const Point& point)
{
    const Point share = (point - plan.area.min) / (plan.area.max - plan.area.min);
    return {place.left() + share.x * place.width(), place.top() + share.y * place.height()};
}

Point onPlane(const CostPlan& plan, const QRectF& place, const QPointF& pixel)
{
    const Point share((pixel.x() - place.left()) / place.width(),
                      (pixel.y() - place.top()) / place.height());
    return plan.area.min + (plan.area.max - plan.area.min) * share;
}

void paintMap(QPainter& painter, const QRectF& place, const CostMap& map, const CostMapLook& look,
              RegionLabels labels)
{
    painter.save();
    painter.setClipRect(place);
    if (!map.values.empty())
        paintCells(painter, place, map, look);
    if (labels == RegionLabels::Shown && map.complete() && !map.plan.measure->isTime())
        paintLabels(painter, place, map, look);
    paintMarks(painter, place, map, look);
    painter.restore();
}

} // namespace app
