// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/files.h"

#include "app/base/number.h"
#include "app/base/write_all.h"
#include "app/cost_map/words.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double margin = 16, width = 720, scale = 2;
constexpr double partSpacing = 8; // logical pixels

QString text(const Point& point) { return shortestText(point.x) + u',' + shortestText(point.y); }

QString winnersOf(const CostPlan& plan, std::uint32_t cheapest)
{
    QStringList keys;
    for (std::size_t i = 0; i < plan.variants.size(); ++i)
        if (cheapest >> i & 1)
            keys << keyOf(plan.variants[i]);
    return keys.join(u' ');
}

std::optional<QString> written(QIODevice& out, const QByteArray& bytes)
{
    const std::string_view view(bytes.data(), std::size_t(bytes.size()));
    return writeAll(out, view) ? std::nullopt : std::optional(out.errorString() + u'.');
}

std::optional<QString> writePng(const CostMap& map, const CostMapLook& look, QIODevice& out)
{
    const QImage image = costPicture(map, look);
    QBuffer buffer;
    if (image.isNull() || !image.save(&buffer, "png"))
        return Text::tr("there is not enough memory for the picture.");
    return written(out, buffer.data());
}

std::optional<QString> writeCsv(const CostMap& map, const CostMapLook&, QIODevice& out)
{
    const auto formats = tableFormats();
    const auto csv = std::ranges::find(formats, QStringLiteral("csv"), &TableFormat::key);
    const Table table = costTable(map);
    return written(out, csv->text({&table, 1}).toUtf8());
}

} // namespace

Table costTable(const CostMap& map)
{
    const CostPlan& plan = map.plan;
    const bool time = plan.measure->isTime();
    Table table{.names = {"x", "y", time ? QStringLiteral("ns") : latin(plan.measure->key)},
                .title = titleOf(plan),
                .key = QStringLiteral("costmap"),
                .facts = {{"fixed_end", plan.end == FixedEnd::End1 ? "1" : "2"},
                          {"fixed_x", shortestText(plan.fixed.x)},
                          {"fixed_y", shortestText(plan.fixed.y)},
                          {"window", text(plan.window.min) + u',' + text(plan.window.max)}}};
    if (plan.shown)
        table.facts.emplace_back("algorithm", keyOf(*plan.shown));
    else
        table.names << QStringLiteral("cheapest");
    for (int row = 0; row < plan.rows; ++row)
        for (int column = 0; column < plan.columns; ++column) {
            const Point end = plan.middleOf(column, row);
            const std::size_t cell = map.at(column, row);
            QStringList fields{shortestText(end.x), shortestText(end.y),
                               time ? QString::number(map.values[cell], 'f', 2)
                                    : shortestText(map.values[cell])};
            if (!plan.shown)
                fields << winnersOf(plan, map.cheapest[cell]);
            table.rows.push_back(fields);
        }
    return table;
}

QImage costPicture(const CostMap& map, const CostMapLook& look)
{
    const QString title = titleOf(map.plan),
                  notes = placesOf(map.plan) + u' ' + noteOf(*map.plan.measure);
    QFont bold = look.chart.font;
    bold.setWeight(QFont::DemiBold);
    const double inner = width - 2 * margin;
    const QRectF all(0, 0, inner, 1e6);
    const QFontMetricsF metrics(look.chart.font), boldMetrics(bold);
    const Point extent = map.plan.area.max - map.plan.area.min;
    const double mapHeight = std::clamp(std::round(inner * extent.y / extent.x), 60., 1200.);
    const double notesHeight = metrics.boundingRect(all, Qt::TextWordWrap, notes).height();
    const double legend = legendHeight(map, inner, look);
    const double height = std::ceil(2 * margin + boldMetrics.height() + partSpacing + mapHeight
                                    + partSpacing + legend + partSpacing + notesHeight);
    QImage image((QSizeF(width, height) * scale).toSize(), QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(scale);
    image.fill(look.chart.paper);
    image.setText(QStringLiteral("Title"), title);
    image.setText(QStringLiteral("Description"), notes);
    QPainter painter(&image);
    double y = margin;
    painter.setPen(look.chart.text);
    painter.setFont(bold);
    painter.drawText(QPointF(margin, y + boldMetrics.ascent()), title);
    y += boldMetrics.height() + partSpacing;
    paintMap(painter, mapPlace(map.plan, {margin, y, inner, mapHeight}), map, look,
             RegionLabels::Shown);
    y += mapHeight + partSpacing;
    paintLegend(painter, {margin, y, inner, legend}, map, look);
    y += legend + partSpacing;
    painter.setFont(look.chart.font);
    painter.setPen(look.chart.muted);
    painter.drawText(QRectF(margin, y, inner, notesHeight + 4), Qt::TextWordWrap, notes);
    painter.end();
    return image;
}

std::span<const CostMapFormat> costMapFormats()
{
    static const std::array all{CostMapFormat{"png", Text::tr("PNG picture"), writePng},
                                CostMapFormat{"csv", Text::tr("CSV table"), writeCsv}};
    return all;
}

std::optional<QString> writeCostMap(const CostMap& map, const QString& path,
                                    const CostMapLook& look)
{
    return writeAs(costMapFormats(), path, map, look);
}

} // namespace app
