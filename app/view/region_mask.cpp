// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/region_mask.h"

#include "app/view/cut_fill.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// QPainter's time for one path grows with the square of the edges in a row of pixels.
constexpr std::size_t mostCorners = 1000;

/// The inside of a window, in device pixels, cut off near the view: at a deep zoom there would be
/// huge numbers.
QPainterPath pathOf(const ClipRegion::Step& step, const View& view, double pixelRatio)
{
    const auto& [min, max] = step.box;
    const std::vector<std::vector<Point>> box{{min, {max.x, min.y}, max, {min.x, max.y}}};
    const clipping::Window seen = view.visible();
    const Point room = (seen.max - seen.min) * 0.01;
    QPainterPath path;
    path.setFillRule(step.rule == FillRule::EvenOdd ? Qt::OddEvenFill : Qt::WindingFill);
    for (const auto& ring : step.rings.empty() ? box : step.rings) {
        QPolygonF polygon;
        for (const Point& p : areaInside(ring, {seen.min - room, seen.max + room})) {
            const Point at = view.toScreen(p) * pixelRatio;
            polygon << QPointF(at.x, at.y);
        }
        path.addPolygon(polygon);
        path.closeSubpath();
    }
    return path;
}

QImage filled(const QPainterPath& path, const QSize& pixels)
{
    QImage image(pixels, QImage::Format_Alpha8);
    image.fill(0);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillPath(path, Qt::black);
    return image;
}

/// Combines each pixel of `mask` with that of `window`.
template <class Combine>
void combine(QImage& mask, const QImage& window, const Combine& combined)
{
    const int width = mask.width();
    for (int y = 0; y < mask.height(); ++y) {
        uchar* const to = mask.scanLine(y);
        std::transform(to, to + width, window.constScanLine(y), to,
                       [&](int all, int one) { return uchar(combined(all, one)); });
    }
}

bool isEmpty(const ClipRegion::Step& step)
{
    return !(step.box.min.x < step.box.max.x && step.box.min.y < step.box.max.y);
}

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

bool isMaskable(const ClipRegion& region)
{
    std::size_t corners = 0;
    for (const ClipRegion::Step& step : region.steps)
        for (const auto& ring : step.rings)
            corners += ring.size();
    return corners <= mostCorners;
}

QImage regionMask(const ClipRegion& region, const View& view, const QSize& pixels,
                  double pixelRatio)
{
    QImage mask(pixels, QImage::Format_Alpha8);
    mask.fill(region.startsFull() ? 255 : 0);
    for (const ClipRegion::Step& step : region.steps) {
        const QImage window =
            filled(isEmpty(step) ? QPainterPath() : pathOf(step, view, pixelRatio), pixels);
        if (step.operation == WindowOperation::Add)
            combine(mask, window, [](int all, int one) { return std::min(255, all + one); });
        else if (step.operation == WindowOperation::CutOut)
            combine(mask, window, [](int all, int one) { return std::max(0, all - one); });
        else
            combine(mask, window, [](int all, int one) { return std::min(all, one); });
    }
    if (region.keep == Keep::Outside && !region.everything())
        combine(mask, mask, [](int all, int) { return 255 - all; });
    return mask;
}

void openAlong(QImage& mask, const DrawList& strokes, double pixelRatio)
{
    constexpr double room = 1; // device pixels: beside the stroke its edge is blurred
    if (strokes.commands.empty())
        return;
    QPainter painter(&mask);
    for (const DrawCommand& command : strokes.commands) {
        painter.setPen(
            QPen(Qt::black, command.stroke->width * pixelRatio + room, Qt::SolidLine, Qt::FlatCap));
        for (const Polyline& polyline : strokes.polylinesOf(command)) {
            const auto points = strokes.pointsOf(polyline);
            for (std::size_t i = 1; i < points.size(); ++i)
                painter.drawLine(points[i - 1] * pixelRatio, points[i] * pixelRatio);
        }
    }
}

namespace {

/// One row of `compose`. Nearly all pixels are in runs that no edge crosses.
void composeRow(std::span<const QRgb> from, const uchar* mask, unsigned least, QRgb* to)
{
    for (std::size_t x = 0; x < from.size();) {
        const uchar covered = mask[x];
        const std::size_t begin = x;
        if (covered == 0 || covered == 255)
            x = std::size_t(std::find_if(mask + x, mask + from.size(),
                                         [&](uchar other) { return other != covered; })
                            - mask);
        if (covered == 255) {
            std::copy(from.begin() + std::ptrdiff_t(begin), from.begin() + std::ptrdiff_t(x),
                      to + begin);
        } else if (covered == 0) {
            for (std::size_t i = begin; i < x; ++i)
                to[i] = reduced(from[i], least);
        } else {
            to[x] = reduced(from[x], least + ((255 - least) * covered + 127) / 255);
            ++x;
        }
    }
}

} // namespace

void compose(const QImage& drawing, const QImage& mask, double ghost, QImage& frame)
{
    const auto least = unsigned(std::lround(255 * ghost));
    const auto width = std::size_t(frame.width());
    for (int y = 0; y < frame.height(); ++y) {
        const auto* const from = reinterpret_cast<const QRgb*>(drawing.constScanLine(y));
        composeRow({from, width}, mask.constScanLine(y), least,
                   reinterpret_cast<QRgb*>(frame.scanLine(y)));
    }
}

} // namespace app
