// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/composed.h"

#include <cmath>

namespace app {
namespace {

/// A premultiplied pixel with the opacity of a pixel reduced to `of255`, rounded: two channels at a
/// time.
QRgb reduced(QRgb pixel, unsigned of255)
{
    const auto scaled = [&](unsigned channels) {
        const unsigned all = channels * of255 + 0x800080U;
        return (all + (all >> 8U & 0xff00ffU)) >> 8U & 0xff00ffU;
    };
    return scaled(pixel & 0xff00ffU) | scaled(pixel >> 8U & 0xff00ffU) << 8U;
}

} // namespace

QImage composed(const QImage& drawing, const QImage& mask, Band band, double ghost)
{
    QImage image(drawing.width(), band.height, QImage::Format_ARGB32_Premultiplied);
    const auto least = unsigned(std::lround(255 * ghost));
    for (int row = 0; row < band.height; ++row) {
        const int y = band.top + row;
        const auto* const from = reinterpret_cast<const QRgb*>(drawing.constScanLine(y));
        const uchar* const covered = mask.constScanLine(y);
        auto* const to = reinterpret_cast<QRgb*>(image.scanLine(row));
        for (int x = 0; x < image.width(); ++x)
            to[x] = reduced(from[x], least + ((255 - least) * covered[x] + 127) / 255);
    }
    return image;
}

} // namespace app
