// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/painted.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include <algorithm>

namespace app {

namespace {

constexpr double dotsPerInch = 96;

/// Adds generic font families, for computers without the font.
QByteArray withFamilies(const QByteArray& svg)
{
    static const QRegularExpression family(QStringLiteral("font-family=\"([^\",]*)\""));
    static const QString mono = QStringLiteral("font-family=\"\\1, monospace\"");
    static const QString sans = QStringLiteral("font-family=\"\\1, sans-serif\"");
    static const QRegularExpression fixed(QStringLiteral("font-family=\"([^\",]*Mono[^\",]*)\""));
    return QString::fromUtf8(svg).replace(fixed, mono).replace(family, sans).toUtf8();
}

/// Replaces the generator's rounded millimetres by whole pixels.
QByteArray withSize(QByteArray svg, const QSize& size)
{
    const qsizetype from = svg.indexOf("<svg width=\""), to = svg.indexOf("viewBox", from);
    if (from >= 0 && to >= 0)
        svg.replace(from, to - from,
                    "<svg width=\"" + QByteArray::number(size.width()) + "\" height=\""
                        + QByteArray::number(size.height()) + "\"\n ");
    return svg;
}

/// Removes the creation time that the writer adds. Blanks of the same length keep the file's offset
/// table valid.
QByteArray withoutTime(QByteArray pdf)
{
    const qsizetype from = pdf.indexOf("/CreationDate");
    const qsizetype to = from < 0 ? -1 : pdf.indexOf(')', from);
    if (to >= 0)
        pdf.replace(from, to + 1 - from, QByteArray(to + 1 - from, ' '));
    return pdf;
}

QPageSize paperFor(const QSizeF& size)
{
    return QPageSize(size * 72 / dotsPerInch, QPageSize::Point, {}, QPageSize::ExactMatch);
}

} // namespace

QByteArray svgOf(const PaintedPage& page, const PaintedCaption& caption)
{
    QBuffer buffer; // the generator does not report write errors of a device
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(int(dotsPerInch));
    generator.setSize(page.size.toSize());
    generator.setViewBox(QRectF(QPointF(), page.size));
    generator.setTitle(caption.title.toHtmlEscaped()); // the generator does not escape them
    generator.setDescription(caption.description.toHtmlEscaped());
    QPainter painter(&generator);
    page.paint(painter);
    painter.end();
    return withSize(withFamilies(buffer.data()), page.size.toSize());
}

QImage imageOf(const PaintedPage& page, double scale)
{
    QImage image((page.size * scale).toSize(), QImage::Format_RGB32);
    if (image.isNull())
        return image;
    image.setDevicePixelRatio(std::max(scale, 1.0));
    image.fill(Qt::white);
    QPainter painter(&image);
    if (scale < 1) // Qt ignores device pixel ratios below 1
        painter.scale(scale, scale);
    page.paint(painter);
    return image;
}

QByteArray pngOf(const PaintedPage& page, const PaintedCaption& caption, double scale)
{
    QImage image = imageOf(page, scale);
    if (image.isNull())
        return {};
    image.setText(QStringLiteral("Title"), caption.title);
    image.setText(QStringLiteral("Description"), caption.description);
    QBuffer buffer;
    return image.save(&buffer, "png") ? buffer.data() : QByteArray();
}

QByteArray pdfOf(std::span<const PaintedPage> pages, const PaintedCaption& caption)
{
    constexpr int resolution = 1200;
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setResolution(resolution);
    writer.setPageSize(paperFor(pages.front().size));
    writer.setPageMargins({});
    writer.setTitle(caption.title);
    writer.setCreator(QStringLiteral("Clearcut"));
    QPainter painter(&writer);
    for (const PaintedPage& page : pages) {
        if (&page != &pages.front()) {
            writer.setPageSize(paperFor(page.size));
            writer.newPage();
        }
        painter.save();
        painter.scale(resolution / dotsPerInch, resolution / dotsPerInch);
        page.paint(painter);
        painter.restore();
    }
    painter.end();
    return withoutTime(buffer.data());
}

} // namespace app
