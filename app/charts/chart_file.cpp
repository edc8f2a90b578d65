// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_file.h"

#include "app/base/write_all.h"
#include "app/charts/chart_layout.h"
#include "app/charts/chart_paint.h"
#include "app/charts/words.h"
#include "app/formats/painted.h"

#include <QBuffer>
#include <QPainter>

#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double margin = 16, width = 720;

void paintPage(QPainter& painter, const Chart& chart, const ChartLook& look, const QSizeF& size)
{
    const QRectF page(QPointF(), size);
    painter.fillRect(page, look.paper);
    paint(painter, page.adjusted(margin, margin, -margin, -margin), chart, look);
}

std::optional<QString> written(QIODevice& out, const QByteArray& bytes)
{
    const std::string_view view(bytes.data(), std::size_t(bytes.size()));
    return writeAll(out, view) ? std::nullopt : std::optional(out.errorString() + u'.');
}

PaintedPage pageOf(const Chart& chart, const ChartLook& look, const QSizeF& size)
{
    return {size,
            [&chart, &look, size](QPainter& painter) { paintPage(painter, chart, look, size); }};
}

PaintedCaption captionOf(const Chart& chart) { return {chart.title, textOf(chart)}; }

std::optional<QString> writeSvg(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    return written(out, svgOf(pageOf(chart, look, size), captionOf(chart)));
}

std::optional<QString> writePdf(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    const PaintedPage page = pageOf(chart, look, size);
    return written(out, pdfOf({&page, 1}, captionOf(chart)));
}

std::optional<QString> writePng(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    constexpr double scale = 2; // high resolution
    const QByteArray bytes = pngOf(pageOf(chart, look, size), captionOf(chart), scale);
    if (bytes.isEmpty())
        return Text::tr("there is not enough memory for the picture.");
    return written(out, bytes);
}

} // namespace

std::span<const ChartFormat> chartFormats()
{
    static const std::array all{ChartFormat{"svg", Text::tr("SVG drawing"), writeSvg},
                                ChartFormat{"pdf", Text::tr("PDF document"), writePdf},
                                ChartFormat{"png", Text::tr("PNG picture"), writePng}};
    return all;
}

QSizeF usualSize(const Chart& chart, const ChartLook& look)
{
    const double height = naturalHeight(chart, width - 2 * margin, look) + 2 * margin;
    return {width, 4 * std::ceil(height / 4)}; // whole points, as required for PDF pages
}

QByteArray chartBytes(const Chart& chart, const ChartFormat& format, const ChartLook& look)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    format.write(chart, look, usualSize(chart, look), buffer);
    return buffer.data();
}

std::optional<QString> writeChart(const Chart& chart, const QString& path, const ChartLook& look)
{
    return writeAs(chartFormats(), path, chart, look, usualSize(chart, look));
}

} // namespace app
