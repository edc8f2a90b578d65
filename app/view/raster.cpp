// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/raster.h"

#include "app/view/caps.h"
#include "app/view/coverage.h"
#include "app/view/long_stroke.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace app {
namespace {

// QPainter is fast for lines of at most one pixel and for many single lines with flat or square
// caps. With round caps it must build outlines, which takes ten times as long.
constexpr double roundEndsShow = 3; // device pixels; round caps are visible from this width on
constexpr qsizetype batch = 1024;
constexpr std::size_t fewPoints = 128; // QPainter is fast for fewer, whatever they cross
constexpr std::size_t stretch = 64;    // points of a long thin polyline painted at a time

QColor qColor(const Colour& c) { return QColor(c.red, c.green, c.blue, c.alpha); }

class Painting {
public:
    Painting(QImage& image, int top, const RasterOptions& options)
        : painter_(&image), cancelled_(options.cancelled), device_(image.rect()),
          ratio_(options.pixelRatio)
    {
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.translate(0, -top);
        painter_.scale(ratio_, ratio_);
        top_ = top / ratio_;
        bottom_ = (top + image.height()) / ratio_;
    }
    void paint(const Plate& plate)
    {
        for (const Coat& coat : plate.coats) {
            if (cancelled_())
                return;
            coat.stroke ? stroke(plate, coat) : fill(plate, coat);
        }
    }

private:
    void fill(const Plate& plate, const Coat& coat)
    {
        if (const auto pixels = pixelsToSum(plate, plate.chainsOf(coat), 0))
            return pixels->isEmpty() ? void() : fillSummed(plate, coat, *pixels);
        QPainterPath path;
        path.setFillRule(coat.rule == FillRule::EvenOdd ? Qt::OddEvenFill : Qt::WindingFill);
        for (const Chain& chain : plate.chainsOf(coat)) {
            const auto points = plate.pointsOf(chain);
            path.moveTo(points[0]);
            for (const QPointF& p : points.subspan(1))
                path.lineTo(p);
        }
        painter_.fillPath(path, qColor(coat.fill));
    }

    void fillSummed(const Plate& plate, const Coat& coat, const QRect& pixels)
    {
        Coverage coverage(pixels);
        for (const Chain& chain : plate.chainsOf(coat)) {
            if (cancelled_())
                return;
            const auto points = plate.pointsOf(chain);
            coverage.add(
                painter_.transform().map(QPolygonF(QList<QPointF>(points.begin(), points.end()))));
        }
        put(coverage.inked(coat.rule, coat.fill), pixels);
    }

    // The pixels of the image that the polylines may cover, if summation takes less time.
    std::optional<QRect> pixelsToSum(const Plate& plate, std::span<const Chain> chains,
                                     double margin) const
    {
        std::size_t count = 0;
        for (const Chain& chain : chains)
            count += chain.count;
        if (count < fewPoints)
            return std::nullopt;
        double height = 0;
        QPointF min = plate.pointsOf(chains[0])[0], max = min;
        for (const Chain& chain : chains) {
            const auto points = plate.pointsOf(chain);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const QPointF& p = points[i];
                min = {std::min(min.x(), p.x()), std::min(min.y(), p.y())};
                max = {std::max(max.x(), p.x()), std::max(max.y(), p.y())};
                height += i == 0 ? 0 : std::abs(p.y() - points[i - 1].y());
            }
        }
        const QPointF room(margin, margin);
        const QRect pixels = painter_.transform()
                                 .mapRect(QRectF(min - room, max + room))
                                 .intersected(device_)
                                 .toAlignedRect();
        const bool summed = worthSumming(height * ratio_, pixels);
        return summed ? std::optional(pixels) : std::nullopt;
    }

    void put(const QImage& image, const QRect& pixels)
    {
        painter_.save();
        painter_.resetTransform();
        painter_.drawImage(pixels.topLeft(), image);
        painter_.restore();
    }

    void stroke(const Plate& plate, const Coat& coat)
    {
        const Ink& ink = *coat.stroke;
        const bool thin = ink.width * ratio_ <= 1;
        const bool roundShows = ink.cap == Cap::Round && ink.width * ratio_ >= roundEndsShow;
        margin_ = ink.width * std::max(1.0, ink.join == Join::Miter ? ink.miterLimit : 1.0) + 1;
        const QPen pen = penFor(ink, ink.cap == Cap::Butt ? Qt::FlatCap
                                     : roundShows         ? Qt::RoundCap
                                                          : Qt::SquareCap);
        const QPen flat =
            penFor(ink, Qt::FlatCap); // for polylines of which an end was made by clipping
        for (const Chain& chain : plate.chainsOf(coat)) {
            if (cancelled_())
                return;
            const auto points = plate.pointsOf(chain);
            const bool own = (chain.capAtStart && chain.capAtEnd) || thin || ink.cap == Cap::Butt;
            if (points.size() == 2 && own && !roundShows) {
                line(points[0], points[1], pen);
                continue;
            }
            flush(pen);
            if (const auto pixels =
                    thin ? std::nullopt : pixelsToSum(plate, {&chain, 1}, margin_)) {
                if (!pixels->isEmpty())
                    strokeSummed(points, chain, capped(ink, roundShows), *pixels);
                continue;
            }
            painter_.setPen(own ? pen : flat);
            polyline(points, chain.closed, thin && ink.colour.alpha == 255);
            if (!own)
                ends(points, chain, ink);
        }
        flush(pen);
    }

    // Every pixel is painted once, however often the stroke crosses itself.
    void strokeSummed(std::span<const QPointF> points, const Chain& chain, const Ink& ink,
                      const QRect& pixels)
    {
        Coverage coverage(pixels);
        visitContours({points, chain, ink}, painter_.transform(), cancelled_,
                      [&](std::span<const QPointF> contour) { coverage.add(contour); });
        if (!cancelled_())
            put(coverage.inked(FillRule::NonZero, ink.colour), pixels);
    }

    // Round caps too small to be visible become square, which QPainter paints faster.
    static Ink capped(Ink ink, bool roundShows)
    {
        if (ink.cap == Cap::Round && !roundShows)
            ink.cap = Cap::Square;
        return ink;
    }

    QPen penFor(const Ink& ink, Qt::PenCapStyle cap) const
    {
        const Qt::PenJoinStyle join = ink.join == Join::Miter   ? Qt::SvgMiterJoin
                                      : ink.join == Join::Round ? Qt::RoundJoin
                                                                : Qt::BevelJoin;
        QPen pen(qColor(ink.colour), ink.width, Qt::SolidLine, cap, join);
        pen.setMiterLimit(ink.miterLimit);
        if (ink.width * ratio_ <= 1) { // the width of a cosmetic pen is in device pixels
            pen.setCosmetic(true);
            pen.setWidthF(ink.width * ratio_);
        }
        return pen;
    }

    bool outside(const QPointF& a, const QPointF& b) const
    {
        const auto [low, high] = std::minmax({a.y(), b.y()});
        return high < top_ - margin_ || low > bottom_ + margin_;
    }

    void line(const QPointF& a, const QPointF& b, const QPen& pen)
    {
        if (outside(a, b))
            return;
        lines_.emplace_back(a, b);
        if (lines_.size() == batch)
            flush(pen);
    }

    void flush(const QPen& pen)
    {
        if (lines_.empty())
            return;
        painter_.setPen(pen);
        painter_.drawLines(lines_.data(), int(lines_.size()));
        lines_.clear();
    }

    void polyline(std::span<const QPointF> points, bool closed, bool inStretches)
    {
        const std::size_t step = inStretches ? stretch : points.size();
        for (std::size_t from = 0; from + 1 < points.size(); from += step) {
            const auto part = points.subspan(from, std::min(step + 1, points.size() - from));
            const auto [low, high] = std::ranges::minmax_element(part, {}, &QPointF::y);
            if (outside(*low, *high))
                continue;
            if (closed && part.size() == points.size()) {
                QPainterPath path(part[0]);
                for (const QPointF& p : part.subspan(1, part.size() - 2))
                    path.lineTo(p);
                path.closeSubpath();
                painter_.strokePath(path, painter_.pen());
            } else {
                painter_.drawPolyline(part.data(), int(part.size()));
            }
        }
    }

    // Adds caps at the stroke's own ends, where the pen could not.
    void ends(std::span<const QPointF> points, const Chain& chain, const Ink& ink)
    {
        if (chain.closed)
            return;
        if (chain.capAtStart)
            end(points[0], points[0] - points[1], ink);
        if (chain.capAtEnd)
            end(points.back(), points.back() - points[points.size() - 2], ink);
    }

    void end(const QPointF& at, const QPointF& away, const Ink& ink)
    {
        if (!outside(at, at))
            painter_.fillPath(capAt(at, away, ink, ink.colour.alpha == 255 ? 0.5 : 0),
                              qColor(ink.colour));
    }

    QPainter painter_;
    const Cancelled& cancelled_;
    QRect device_;
    double ratio_;
    double top_ = 0, bottom_ = 0; // logical pixels
    double margin_ = 0;
    std::vector<QLineF> lines_;
};

QImage transparent(int width, int height)
{
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    return image;
}

} // namespace

QImage rasterised(const Picture& picture, Band band, const RasterOptions& options)
{
    QImage image = transparent(options.width, band.height);
    if (!picture.ghost.coats.empty()) {
        QImage below = transparent(options.width, band.height);
        Painting(below, band.top, options).paint(picture.ghost);
        QPainter painter(&image);
        painter.setOpacity(options.ghost);
        painter.drawImage(0, 0, below);
    }
    Painting painting(image, band.top, options);
    painting.paint(picture.kept);
    painting.paint(picture.lit);
    painting.paint(picture.differing);
    return image;
}

std::vector<Band> bandsOf(int height, int threads)
{
    std::vector<Band> bands;
    for (int i = 0; i < threads; ++i) {
        const int top = height * i / threads, end = height * (i + 1) / threads;
        if (end > top)
            bands.push_back({top, end - top});
    }
    return bands;
}

QImage joined(std::span<const QImage> bands)
{
    int height = 0;
    for (const QImage& band : bands)
        height += band.height();
    if (bands.empty())
        return {};
    QImage all(bands[0].width(), height, bands[0].format());
    int row = 0;
    for (const QImage& band : bands) {
        std::memcpy(all.scanLine(row), band.constBits(), std::size_t(band.sizeInBytes()));
        row += band.height();
    }
    return all;
}

} // namespace app
