// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/raster.h"

#include "app/view/caps.h"
#include "app/view/coverage.h"
#include "app/view/hairlines.h"
#include "app/view/image_pixels.h"
#include "app/view/long_stroke.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

// QPainter is fast for polylines of at most one pixel and for many single lines with flat or square
// caps. With round caps it must build outlines, which takes ten times as long.
constexpr double roundEndsShow = 3; // device pixels; round caps are visible from this width on
constexpr qsizetype batch = 1024;
constexpr std::uint32_t manyLines = 64; // of one colour: worth tiles of their own
constexpr std::size_t stretch = 64;     // points of a long thin polyline painted at a time

QColor qColor(const Colour& c) { return QColor(c.red, c.green, c.blue, c.alpha); }

class Painting {
public:
    Painting(QImage& image, int top, const RasterOptions& options)
        : image_(image), painter_(&image), cancelled_(options.cancelled),
          device_(image.rect()), band_{top, image.height()}, ratio_(options.pixelRatio)
    {
        painter_.setRenderHint(QPainter::Antialiasing);
        painter_.translate(0, -top);
        painter_.scale(ratio_, ratio_);
        top_ = top / ratio_;
        bottom_ = (top + image.height()) / ratio_;
    }
    void paint(const DrawList& drawList)
    {
        for (const DrawCommand& command : drawList.commands) {
            if (cancelled_())
                return;
            if (command.image)
                image(drawList.images[*command.image]);
            else
                command.stroke ? stroke(drawList, command) : fill(drawList, command);
        }
    }

private:
    void image(const DrawnImage& image)
    {
        painter_.save();
        painter_.setTransform(image.toScreen, true);
        paintUnderlay(painter_, *image.underlay, image.opacity);
        painter_.restore();
    }

    void fill(const DrawList& drawList, const DrawCommand& command)
    {
        if (const auto pixels = pixelsToSum(drawList, drawList.polylinesOf(command), 0))
            return pixels->isEmpty() ? void() : fillSummed(drawList, command, *pixels);
        QPainterPath path;
        path.setFillRule(command.rule == FillRule::EvenOdd ? Qt::OddEvenFill : Qt::WindingFill);
        for (const Polyline& polyline : drawList.polylinesOf(command)) {
            const auto points = drawList.pointsOf(polyline);
            path.moveTo(points[0]);
            for (const QPointF& p : points.subspan(1))
                path.lineTo(p);
        }
        painter_.fillPath(path, qColor(command.fill));
    }

    void fillSummed(const DrawList& drawList, const DrawCommand& command, const QRect& pixels)
    {
        Coverage coverage(pixels);
        for (const Polyline& polyline : drawList.polylinesOf(command)) {
            if (cancelled_())
                return;
            const auto points = drawList.pointsOf(polyline);
            coverage.add(
                painter_.transform().map(QPolygonF(QList<QPointF>(points.begin(), points.end()))));
        }
        put(coverage.coloured(command.rule, command.fill), pixels);
    }

    // The pixels of the image that the polylines may cover, if summation takes less time.
    std::optional<QRect> pixelsToSum(const DrawList& drawList, std::span<const Polyline> polylines,
                                     double margin) const
    {
        std::size_t count = 0;
        for (const Polyline& polyline : polylines)
            count += polyline.count;
        if (count < fewPoints)
            return std::nullopt;
        double height = 0;
        QPointF min = drawList.pointsOf(polylines[0])[0], max = min;
        for (const Polyline& polyline : polylines) {
            const auto points = drawList.pointsOf(polyline);
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

    void stroke(const DrawList& drawList, const DrawCommand& command)
    {
        const StrokeStyle& strokeStyle = *command.stroke;
        const bool thin = strokeStyle.width * ratio_ <= 1;
        const bool roundShows =
            strokeStyle.cap == Cap::Round && strokeStyle.width * ratio_ >= roundEndsShow;
        margin_ =
            strokeStyle.width
                * std::max(1.0, strokeStyle.join == Join::Miter ? strokeStyle.miterLimit : 1.0)
            + 1;
        const QPen pen = penFor(strokeStyle, strokeStyle.cap == Cap::Butt ? Qt::FlatCap
                                             : roundShows                 ? Qt::RoundCap
                                                                          : Qt::SquareCap);
        const bool hair = thin && strokeStyle.colour.alpha == 255;
        const bool many = hair && command.polylines >= manyLines;
        if (many && !hairlines_)
            hairlines_.emplace(image_.width(), band_);
        const QPen flat =
            penFor(strokeStyle, Qt::FlatCap); // for polylines of which an end was made by clipping
        for (const Polyline& polyline : drawList.polylinesOf(command)) {
            if (cancelled_())
                return;
            const auto points = drawList.pointsOf(polyline);
            const bool own =
                (polyline.capAtStart && polyline.capAtEnd) || thin || strokeStyle.cap == Cap::Butt;
            if (points.size() == 2 && own && !roundShows) {
                if (!hair || !hairline(points[0], points[1], strokeStyle, many))
                    line(points[0], points[1], pen);
                continue;
            }
            flush(pen);
            if (const auto pixels =
                    thin ? std::nullopt : pixelsToSum(drawList, {&polyline, 1}, margin_)) {
                if (!pixels->isEmpty())
                    strokeSummed(points, polyline, capped(strokeStyle, roundShows), *pixels);
                continue;
            }
            painter_.setPen(own ? pen : flat);
            strokePolyline(points, polyline.closed, hair);
            if (!own)
                ends(points, polyline, strokeStyle);
        }
        flush(pen);
        if (many)
            hairlines_->paintOn(image_);
    }

    /// False if it must be painted otherwise.
    bool hairline(const QPointF& a, const QPointF& b, const StrokeStyle& strokeStyle, bool many)
    {
        if (outside(a, b))
            return true;
        const auto line =
            Hairline::of(a * ratio_, b * ratio_, strokeStyle.width * ratio_, strokeStyle.cap);
        if (line)
            many ? hairlines_->add(*line, strokeStyle.colour)
                 : paintHairline(image_, band_.top, *line, strokeStyle.colour);
        return line.has_value();
    }

    // Every pixel is painted once, however often the stroke crosses itself.
    void strokeSummed(std::span<const QPointF> points, const Polyline& polyline,
                      const StrokeStyle& strokeStyle, const QRect& pixels)
    {
        Coverage coverage(pixels);
        visitContours({points, polyline, strokeStyle}, painter_.transform(), cancelled_,
                      [&](std::span<const QPointF> contour) { coverage.add(contour); });
        if (!cancelled_())
            put(coverage.coloured(FillRule::NonZero, strokeStyle.colour), pixels);
    }

    // Round caps too small to be visible become square, which QPainter paints faster.
    static StrokeStyle capped(StrokeStyle strokeStyle, bool roundShows)
    {
        if (strokeStyle.cap == Cap::Round && !roundShows)
            strokeStyle.cap = Cap::Square;
        return strokeStyle;
    }

    QPen penFor(const StrokeStyle& strokeStyle, Qt::PenCapStyle cap) const
    {
        const Qt::PenJoinStyle join = strokeStyle.join == Join::Miter   ? Qt::SvgMiterJoin
                                      : strokeStyle.join == Join::Round ? Qt::RoundJoin
                                                                        : Qt::BevelJoin;
        QPen pen(qColor(strokeStyle.colour), strokeStyle.width, Qt::SolidLine, cap, join);
        pen.setMiterLimit(strokeStyle.miterLimit);
        if (strokeStyle.width * ratio_ <= 1) { // the width of a cosmetic pen is in device pixels
            pen.setCosmetic(true);
            pen.setWidthF(strokeStyle.width * ratio_);
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

    void strokePolyline(std::span<const QPointF> points, bool closed, bool inStretches)
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
    void ends(std::span<const QPointF> points, const Polyline& polyline,
              const StrokeStyle& strokeStyle)
    {
        if (polyline.closed)
            return;
        if (polyline.capAtStart)
            end(points[0], points[0] - points[1], strokeStyle);
        if (polyline.capAtEnd)
            end(points.back(), points.back() - points[points.size() - 2], strokeStyle);
    }

    void end(const QPointF& at, const QPointF& away, const StrokeStyle& strokeStyle)
    {
        if (!outside(at, at))
            painter_.fillPath(
                capAt(at, away, strokeStyle, strokeStyle.colour.alpha == 255 ? 0.5 : 0),
                qColor(strokeStyle.colour));
    }

    QImage& image_;
    QPainter painter_;
    const Cancelled& cancelled_;
    QRect device_;
    Band band_;
    double ratio_;
    double top_ = 0, bottom_ = 0; // logical pixels
    double margin_ = 0;
    std::vector<QLineF> lines_;
    std::optional<Hairlines> hairlines_;
};

QImage transparent(int width, int height)
{
    QImage image(width, height, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::transparent);
    return image;
}

} // namespace

QImage rasterised(const Picture& picture, Band band, const RasterOptions& options,
                  const QImage& base)
{
    if (picture.isEmpty() && !base.isNull())
        return base;
    QImage image = transparent(options.width, band.height);
    if (!picture.selected.commands.empty())
        Painting(image, band.top, options).paint(picture.selected);
    if (!picture.ghost.commands.empty()) {
        QImage below = transparent(options.width, band.height);
        Painting(below, band.top, options).paint(picture.ghost);
        QPainter painter(&image);
        painter.setOpacity(options.ghost);
        painter.drawImage(0, 0, below);
    }
    if (!base.isNull())
        QPainter(&image).drawImage(0, 0, base);
    Painting painting(image, band.top, options);
    painting.paint(picture.kept);
    painting.paint(picture.differing);
    painting.paint(picture.borders);
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

} // namespace app
