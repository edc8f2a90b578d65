// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_file.h"

#include "app/charts/chart_layout.h"
#include "app/charts/chart_paint.h"
#include "app/charts/words.h"
#include "app/formats/replace_file.h"
#include "app/formats/write_all.h"
#include "app/latin.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double margin = 16, width = 720, dotsPerInch = 96;

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

std::optional<QString> writeSvg(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    QBuffer buffer; // the generator does not say what the device refused
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(int(dotsPerInch));
    generator.setSize(size.toSize());
    generator.setViewBox(QRectF(QPointF(), size));
    generator.setTitle(chart.title);
    generator.setDescription(textOf(chart));
    QPainter painter(&generator);
    paintPage(painter, chart, look, size);
    painter.end();
    QByteArray bytes = buffer.data(); // for who has not got the font
    bytes.replace("font-family=\"" + look.font.family().toUtf8() + '"',
                  "font-family=\"" + look.font.family().toUtf8() + ", sans-serif\"");
    return written(out, bytes);
}

std::optional<QString> writePdf(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    constexpr int resolution = 1200;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(resolution);
    writer.setPageSize(
        QPageSize(size * 72 / dotsPerInch, QPageSize::Point, {}, QPageSize::ExactMatch));
    writer.setPageMargins({});
    writer.setTitle(chart.title);
    writer.setCreator(QStringLiteral("Clearcut"));
    QPainter painter(&writer);
    painter.scale(resolution / dotsPerInch, resolution / dotsPerInch);
    paintPage(painter, chart, look, size);
    painter.end();
    return written(out, buffer.data());
}

std::optional<QString> writePng(const Chart& chart, const ChartLook& look, const QSizeF& size,
                                QIODevice& out)
{
    constexpr double scale = 2; // sharp on every screen
    QImage image((size * scale).toSize(), QImage::Format_RGB32);
    if (image.isNull())
        return Charts::tr("there is not enough memory for the picture.");
    image.setDevicePixelRatio(scale);
    image.setText(QStringLiteral("Title"), chart.title);
    image.setText(QStringLiteral("Description"), textOf(chart));
    QPainter painter(&image);
    paintPage(painter, chart, look, size);
    painter.end();
    QBuffer buffer;
    if (!image.save(&buffer, "png"))
        return Charts::tr("there is not enough memory for the picture.");
    return written(out, buffer.data());
}

QString keysText()
{
    QStringList keys;
    for (const ChartFormat& format : chartFormats())
        keys << u'.' + latin(format.key);
    return keys.join(QStringLiteral(", "));
}

} // namespace

std::span<const ChartFormat> chartFormats()
{
    static const std::array all{ChartFormat{"svg", Charts::tr("SVG drawing"), writeSvg},
                                ChartFormat{"pdf", Charts::tr("PDF document"), writePdf},
                                ChartFormat{"png", Charts::tr("PNG picture"), writePng}};
    return all;
}

const ChartFormat* findChartFormat(QStringView key)
{
    const auto found = std::ranges::find_if(chartFormats(), [&](const ChartFormat& format) {
        return key.compare(QLatin1StringView(format.key.data(), qsizetype(format.key.size())),
                           Qt::CaseInsensitive)
               == 0;
    });
    return found == chartFormats().end() ? nullptr : &*found;
}

QSizeF usualSize(const Chart& chart, const ChartLook& look)
{
    const double height = naturalHeight(chart, width - 2 * margin, look) + 2 * margin;
    return {width, 4 * std::ceil(height / 4)}; // whole points, as a PDF page has them
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
    const ChartFormat* format = findChartFormat(QFileInfo(path).suffix());
    if (!format)
        return Charts::tr("%1: a chart is written as %2; give the file one of these endings.")
            .arg(path, keysText());
    const auto error = replaceFile(path, [&](QIODevice& out) {
        return format->write(chart, look, usualSize(chart, look), out);
    });
    return error ? std::optional(Charts::tr("Cannot write %1: %2").arg(path, *error)) : error;
}

} // namespace app
