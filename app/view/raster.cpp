// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/raster.h"

#include "app/view/caps.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace app {
namespace {

// QPainter is fast for lines of at most one pixel and for many single ones with flat or square
// ends; it takes ten times as long where it has to make an outline of round ends.
constexpr double roundEndsShow = 3; // device pixels
constexpr qsizetype batch = 1024;
constexpr std::size_t stretch = 64; // points of a long thin polyline that are painted at a time

QColor qColor(const Colour& c) { return QColor(c.red, c.green, c.blue, c.alpha); }

class Painting {
public:
    Painting(QImage& image, int top, double pixelRatio) : painter_(&image)
    {
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.translate(0, -top);
        painter_.scale(pixelRatio, pixelRatio);
        top_ = top / pixelRatio;
        bottom_ = (top + image.height()) / pixelRatio;
        ratio_ = pixelRatio;
    }
    void paint(const Plate& plate)
    {
        for (const Coat& coat : plate.coats)
            coat.stroke ? stroke(plate, coat) : fill(plate, coat);
    }

private:
    void fill(const Plate& plate, const Coat& coat)
    {
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
            penFor(ink, Qt::FlatCap); // for chains of which an end was made by the window
        for (const Chain& chain : plate.chainsOf(coat)) {
            const auto points = plate.pointsOf(chain);
            const bool own = (chain.capAtStart && chain.capAtEnd) || thin || ink.cap == Cap::Butt;
            if (points.size() == 2 && own && !roundShows) {
                line(points[0], points[1], pen);
                continue;
            }
            flush(pen);
            painter_.setPen(own ? pen : flat);
            polyline(points, chain.closed, thin && ink.colour.alpha == 255);
            if (!own)
                ends(points, chain, ink);
        }
        flush(pen);
    }

    QPen penFor(const Ink& ink, Qt::PenCapStyle cap) const
    {
        const Qt::PenJoinStyle join = ink.join == Join::Miter   ? Qt::SvgMiterJoin
                                      : ink.join == Join::Round ? Qt::RoundJoin
                                                                : Qt::BevelJoin;
        QPen pen(qColor(ink.colour), ink.width, Qt::SolidLine, cap, join);
        pen.setMiterLimit(ink.miterLimit);
        if (ink.width * ratio_ <= 1) { // a cosmetic pen's width is in device pixels
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

    // The caps of the stroke's own ends, where the pen could not make them.
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
    double top_ = 0, bottom_ = 0, ratio_ = 1; // logical pixels
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

QImage rasterised(const Picture& picture, int width, Band band, double pixelRatio, double ghost)
{
    QImage image = transparent(width, band.height);
    if (!picture.ghost.coats.empty()) {
        QImage below = transparent(width, band.height);
        Painting(below, band.top, pixelRatio).paint(picture.ghost);
        QPainter painter(&image);
        painter.setOpacity(ghost);
        painter.drawImage(0, 0, below);
    }
    Painting painting(image, band.top, pixelRatio);
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
