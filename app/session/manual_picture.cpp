// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/manual_picture.h"

#include "app/session/samples.h"

#include <QPainter>
#include <QUrl>
#include <QUrlQuery>

#include <algorithm>

namespace app {

namespace {

constexpr double discSize = 22; // logical pixels
constexpr int mostDiscs = 9;

std::optional<ManualPicture::Disc> discIn(const QString& number, const QString& place)
{
    bool isNumber = false, isX = false, isY = false;
    const ManualPicture::Disc disc{number.toInt(&isNumber),
                                   {place.section(u',', 0, 0).toDouble(&isX) / 100,
                                    place.section(u',', 1).toDouble(&isY) / 100}};
    const bool isInside =
        disc.at.x() >= 0 && disc.at.x() <= 1 && disc.at.y() >= 0 && disc.at.y() <= 1;
    return isNumber && isX && isY && isInside && disc.number > 0 && disc.number <= mostDiscs
               ? std::optional(disc)
               : std::nullopt;
}

void paint(QPainter& painter, const ManualPicture::Disc& disc, const QSize& points,
           const DiscLook& look)
{
    const QPointF middle(disc.at.x() * points.width(), disc.at.y() * points.height());
    painter.setPen(QPen(look.text, 1.5)); // a rim that is seen on dark lines
    painter.setBrush(look.ground);
    painter.drawEllipse(middle, discSize / 2, discSize / 2);
    QFont font = look.font;
    font.setPixelSize(int(discSize * 0.6));
    font.setBold(true);
    painter.setFont(font);
    painter.drawText(QRectF(middle - QPointF(discSize, discSize) / 2, QSizeF(discSize, discSize)),
                     Qt::AlignCenter, QString::number(disc.number));
}

} // namespace

std::optional<ManualPicture> manualPicture(const QString& address)
{
    const QUrl url(address);
    const auto all = samples();
    const auto sample = std::ranges::find(all, url.path(), &Sample::key);
    if (url.scheme() != QStringLiteral("sample") || sample == all.end())
        return std::nullopt;
    ManualPicture picture{sample->file, {}};
    for (const auto& [number, place] : QUrlQuery(url).queryItems())
        if (const auto disc = discIn(number, place))
            picture.discs.push_back(*disc);
        else
            return std::nullopt;
    return picture;
}

QSize manualPictureSize(int width) { return {width, width * 297 / 420}; } // as paper is

QImage painted(const ManualPicture& picture, const QSize& points, double pixelRatio,
               const ThumbnailColours& colours, const DiscLook& discs)
{
    QImage image = samplePicture(picture.file, points, pixelRatio, colours);
    if (image.isNull())
        return image;
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const ManualPicture::Disc& disc : picture.discs)
        paint(painter, disc, points, discs);
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(discs.frame, 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRect({}, points).adjusted(0, 0, -1, -1));
    return image;
}

} // namespace app
