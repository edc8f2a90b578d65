// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/coverage.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double subpixels = 64; // steps of QPainter's grid along a pixel's side

QPointF onGrid(const QPointF& p)
{
    return {std::round(p.x() * subpixels) / subpixels, std::round(p.y() * subpixels) / subpixels};
}

// Rounds coverage as QPainter does.
int level(double sum, FillRule rule)
{
    double share = std::abs(sum);
    if (rule == FillRule::EvenOdd) {
        share = std::fmod(share, 2);
        share = share > 1 ? 2 - share : share;
    }
    return int(std::min(share * 256, 255.0));
}

} // namespace

Coverage::Coverage(const QRect& pixels)
    : pixels_(pixels), stride_(std::size_t(std::max(0, pixels.width())) + 1),
      sums_(stride_ * std::size_t(std::max(0, pixels.height())), 0)
{
}

void Coverage::add(std::span<const QPointF> contour)
{
    if (contour.empty())
        return;
    QPointF last = onGrid(contour.back());
    for (const QPointF& p : contour) {
        const QPointF next = onGrid(p);
        addEdge(last, next);
        last = next;
    }
}

// Ignores the parts above and below the pixels, and edges that are not finite.
void Coverage::addEdge(const QPointF& a, const QPointF& b)
{
    const bool down = a.y() < b.y();
    const QPointF from = (down ? a : b) - pixels_.topLeft(),
                  to = (down ? b : a) - pixels_.topLeft();
    const double top = std::max(from.y(), 0.0), bottom = std::min(to.y(), double(pixels_.height()));
    if (!(top < bottom) || !std::isfinite(from.x() + to.x() + from.y() + to.y()))
        return;
    const double slope = (to.x() - from.x()) / (to.y() - from.y());
    const double left = std::min(from.x(), to.x()), right = std::max(from.x(), to.x());
    const auto x = [&](double y) {
        return std::clamp(from.x() + (y - from.y()) * slope, left, right);
    };
    double y = top, at = x(top);
    for (int row = int(top); y < bottom; ++row) {
        const double next = std::min(row + 1.0, bottom), end = x(next);
        addToRow(row, at, end, down ? next - y : y - next);
        y = next;
        at = end;
    }
}

// An edge within one row covers everything to its right. An edge left of the pixels counts as if at
// their left end.
void Coverage::addToRow(int row, double x0, double x1, double height)
{
    if (x0 > x1)
        std::swap(x0, x1);
    float* const sums = sums_.data() + std::size_t(row) * stride_;
    const double width = pixels_.width();
    if (x0 >= width)
        return;
    if (x1 <= 0) {
        sums[0] += float(height);
        return;
    }
    const double steepness = x1 > x0 ? height / (x1 - x0) : 0;
    if (x0 < 0) {
        sums[0] -= float(steepness * x0);
        x0 = 0;
    }
    const auto addPart = [&](int pixel, double middle, double part) {
        sums[pixel] += float(part * (1 - middle));
        sums[pixel + 1] += float(part * middle);
    };
    const int first = int(x0);
    if (x1 <= first + 1)
        return addPart(first, (x0 + x1) / 2 - first, x1 > x0 ? steepness * (x1 - x0) : height);
    const double end = std::min(x1, width);
    for (int pixel = first; pixel < end; ++pixel) {
        const double from = std::max(x0, double(pixel)), to = std::min(end, pixel + 1.0);
        addPart(pixel, (from + to) / 2 - pixel, steepness * (to - from));
    }
}

QImage Coverage::coloured(FillRule rule, const Colour& colour) const
{
    QImage image(pixels_.size(), QImage::Format_ARGB32_Premultiplied);
    std::array<QRgb, 256> colours{};
    for (int i = 0; i < 256; ++i)
        colours[std::size_t(i)] = qPremultiply(
            qRgba(colour.red, colour.green, colour.blue, (colour.alpha * i + 127) / 255));
    for (int y = 0; y < image.height(); ++y) {
        const float* const sums = sums_.data() + std::size_t(y) * stride_;
        auto* const line = reinterpret_cast<QRgb*>(image.scanLine(y));
        double sum = 0;
        for (int x = 0; x < image.width(); ++x) {
            sum += double(sums[x]);
            line[x] = colours[std::size_t(level(sum, rule))];
        }
    }
    return image;
}

bool worthSumming(double height, const QRect& pixels)
{
    const double rows = pixels.height(), edgesInRow = height / std::max(1.0, rows);
    return height * edgesInRow > rows * pixels.width();
}

} // namespace app
