// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/painted.h"

#include "app/base/text.h"

#include <QBuffer>
#include <QImage>
#include <QPainter>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

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

Paper paperOf(const Page& page)
{
    const double unit = page.millimetresPerUnit();
    const auto size = [&](Length length, double units) { // in user units
        const double ratio = infoOf(length.unit).millimetres / unit;
        return length.value * ratio > 0 ? length.value * ratio
                                        : units; // an open size equals that of the page
    };
    const Point paper{size(page.width, page.size.x), size(page.height, page.size.y)};
    return {paper * unit, unit, page.min - (paper - page.size) / 2.0};
}

std::optional<QString> faultOf(const Page& page)
{
    constexpr double smallestUnit = 1e-100, largestUnit = 1e100; // millimetres
    constexpr double largest = 1e300;                            // which readers accept
    const double unit = page.millimetresPerUnit();
    const auto fits = [&](double min, double size, const Length& length) {
        const double paper = size * unit;
        return size > 0 && size <= largest && paper > 0 && paper <= largest
               && std::abs(min) <= largest && std::abs(min) * unit <= largest
               && std::abs(length.value) <= largest;
    };
    if (unit >= smallestUnit && unit <= largestUnit && fits(page.min.x, page.size.x, page.width)
        && fits(page.min.y, page.size.y, page.height))
        return std::nullopt;
    return Text::tr("the page is too large or too small to calculate with. Its width, height and "
                    "view box must give a unit between 1e-100 mm and 1e100 mm.");
}

} // namespace app
