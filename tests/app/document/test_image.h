// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/underlay.h"

#include <QBuffer>
#include <QImage>

/// Red at the left, green at the right, with a blue row at the top.
inline QImage testImage(int width, int height)
{
    QImage image(width, height, QImage::Format_RGB32);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            image.setPixel(x, y,
                           y == 0                ? qRgb(0, 0, 255)
                           : x < (width + 1) / 2 ? qRgb(255, 0, 0)
                                                 : qRgb(0, 255, 0));
    return image;
}

inline QByteArray bytesOf(const QImage& image, const char* format = "png")
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, format);
    return bytes;
}

/// An animation of 4 by 3 pixels: the picture of testImage(4, 3), then a white one.
inline QByteArray testGif()
{
    return QByteArray::fromBase64("R0lGODlhBAADAIEAAP8AAAD/AAAA/"
                                  "wAAACH5BAAKAAAALAAAAAAEAAMAAAgNAAUIFAAAQIAABQ8GBAAh+QQACgAAACwA"
                                  "AAAABAADAIH///8AAAAAAAAAAAAICAABCBxIUGBAADs=");
}

inline std::shared_ptr<const app::ImageFile> testFile(int width = 4, int height = 3)
{
    auto made = app::imageFileOf(bytesOf(testImage(width, height)));
    return std::get<std::shared_ptr<const app::ImageFile>>(made);
}

/// Each pixel is `scale` units large; its corner is at the point.
inline app::Underlay testUnderlay(const app::Point& at = {}, double scale = 1)
{
    return {.file = testFile(), .place = {{scale, 0}, {0, scale}, {0, 0}, at}};
}
