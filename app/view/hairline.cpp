// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairline.h"

#include <cmath>
#include <utility>

namespace app {
namespace {

constexpr double farAway = 1 << 20; // device pixels

std::int64_t fixed(double x) { return std::int64_t(x * 4294967296.0); }

} // namespace

std::optional<Hairline> Hairline::of(QPointF a, QPointF b, double width, Cap cap)
{
    for (const double x : {a.x(), a.y(), b.x(), b.y()})
        if (!(std::abs(x) < farAway))
            return std::nullopt;
    const bool steep = std::abs(b.y() - a.y()) > std::abs(b.x() - a.x());
    if (steep)
        a = a.transposed(), b = b.transposed();
    if (a.x() > b.x())
        std::swap(a, b);
    const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
    const double more = cap == Cap::Butt ? 0 : 0.5;
    return Hairline{a.x() - more,
                    b.x() + more,
                    fixed(a.y() + (0.5 - a.x()) * slope - 0.5),
                    fixed(slope),
                    unsigned(std::clamp(width, 0.0, 1.0) * 256),
                    steep};
}

void paintHairline(QImage& band, int top, const Hairline& line, const Colour& colour)
{
    const int begin = line.steep ? top : 0, beside = line.steep ? 0 : top;
    const int end = line.steep ? top + band.height() : band.width();
    const int endBeside = line.steep ? band.width() : top + band.height();
    const int first = std::max(int(std::floor(line.from)), begin);
    const int last = std::min(int(std::floor(line.to)), end - 1);
    const QRgb above = qRgb(colour.red, colour.green, colour.blue);
    auto* const pixels = reinterpret_cast<QRgb*>(band.bits());
    const qsizetype row = band.bytesPerLine() / qsizetype(sizeof(QRgb));
    const qsizetype stepAlong = line.steep ? row : 1, stepAcross = line.steep ? 1 : row;
    line.visitPixels(first, last, [&](int along, int across, unsigned share) {
        if (across < beside || across >= endBeside)
            return;
        QRgb& pixel = pixels[(along - begin) * stepAlong + (across - beside) * stepAcross];
        pixel = mixed(above, pixel, std::min(share, 255U));
    });
}

} // namespace app
