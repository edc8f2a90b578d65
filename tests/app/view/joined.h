// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

#include <cstring>
#include <span>

/// The image composed of bands.
inline QImage joined(std::span<const QImage> bands)
{
    int height = 0;
    for (const QImage& band : bands)
        height += band.height();
    QImage all(bands[0].width(), height, bands[0].format());
    int row = 0;
    for (const QImage& band : bands) {
        std::memcpy(all.scanLine(row), band.constBits(), std::size_t(band.sizeInBytes()));
        row += band.height();
    }
    return all;
}
