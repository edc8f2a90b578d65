// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/summed_object.h"

#include "app/view/coverage.h"
#include "app/view/dashes.h"
#include "app/view/long_stroke.h"
#include "app/view/painter_path.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

constexpr std::size_t fewPoints = 128;  // QPainter is fast for fewer, whatever they cross
constexpr double shortestPattern = 0.1; // device pixels; finer dashes look like plain grey
constexpr double mostDashes = 1e7;      // in a path; a path with more is mostly off the page
constexpr double finer = 4;             // how much finer than Qt curves are flattened
constexpr int pixelsAtATime = 1 << 24;  // these use 128 MB

struct Polyline {
    QPolygonF points; ///< device pixels
    bool closed;
};

std::vector<Polyline> polylinesOf(const Path& path, const QTransform& toDevice)
{
    const QTransform toFiner = toDevice * QTransform::fromScale(finer, finer);
    const QTransform back = QTransform::fromScale(1 / finer, 1 / finer);
    std::vector<Polyline> polylines;
    for (const Subpath& subpath : path.subpaths()) {
        const QPainterPath alone = painterPath({&subpath, 1}, FillRule::NonZero);
        for (const QPolygonF& points : alone.toSubpathPolygons(toFiner))
            if (points.size() > 1)
                polylines.push_back({back.map(points), subpath.closed});
    }
    return polylines;
}

// The pixels of the painter's image that may be covered, if summation takes less time.
std::optional<QRect> pixelsToSum(std::span<const Polyline> polylines, double margin,
                                 const QPainter& painter)
{
    std::size_t count = 0;
    double height = 0;
    QRectF around;
    for (const Polyline& polyline : polylines) {
        count += std::size_t(polyline.points.size());
        around |= polyline.points.boundingRect().adjusted(-margin, -margin, margin, margin);
        for (qsizetype i = 1; i < polyline.points.size(); ++i)
            height += std::abs(polyline.points[i].y() - polyline.points[i - 1].y());
    }
    const QRectF image(0, 0, painter.device()->width(), painter.device()->height());
    const QRect pixels = around.intersected(image).toAlignedRect();
    const bool summed = count >= fewPoints && worthSumming(height, pixels);
    return summed ? std::optional(pixels) : std::nullopt;
}

// Sums in bands: the pixels of a whole large picture would need twice its memory again.
template <class Add>
void sum(QPainter& painter, const QRect& pixels, FillRule rule, const Colour& colour, Add add)
{
    painter.save();
    painter.resetTransform();
    const int rows = std::max(1, pixelsAtATime / std::max(1, pixels.width()));
    for (int top = pixels.top(); top <= pixels.bottom(); top += rows) {
        Coverage coverage(
            QRect(pixels.left(), top, pixels.width(), std::min(rows, pixels.bottom() + 1 - top)));
        add(coverage);
        painter.drawImage(QPoint(pixels.left(), top), coverage.inked(rule, colour));
    }
    painter.restore();
}

// The polylines that the pen draws, divided into dashes; empty if there are too many dashes.
std::optional<std::vector<Polyline>> drawnParts(std::vector<Polyline> polylines, const Style& style,
                                                double scale)
{
    const double period = scale * std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
    if (!(period >= shortestPattern))
        return polylines;
    std::vector<double> pattern = style.dashes;
    for (double& length : pattern)
        length *= scale;
    std::vector<Polyline> parts;
    for (const Polyline& polyline : polylines) {
        double length = 0;
        for (qsizetype i = 1; i < polyline.points.size(); ++i)
            length += QLineF(polyline.points[i - 1], polyline.points[i]).length();
        if (!(length / period < mostDashes))
            return std::nullopt;
        for (const auto& dash : dashes(polyline.points, pattern, style.dashOffset * scale, 0))
            parts.push_back({QPolygonF(QList<QPointF>(dash.begin(), dash.end())), false});
    }
    return parts;
}

void addStroke(Coverage& coverage, const Polyline& part, const Ink& ink)
{
    const Chain chain{0, std::uint32_t(part.points.size()), part.closed, true, true};
    visitContours({part.points, chain, ink}, {}, neverCancelled,
                  [&](std::span<const QPointF> contour) { coverage.add(contour); });
}

} // namespace

bool fillSummed(QPainter& painter, const Object& object)
{
    const auto polylines = polylinesOf(object.path, painter.transform());
    const auto pixels = pixelsToSum(polylines, 0, painter);
    if (!pixels)
        return false;
    sum(painter, *pixels, object.style.fillRule, *object.style.fill, [&](Coverage& coverage) {
        for (const Polyline& polyline : polylines)
            coverage.add(polyline.points);
    });
    return true;
}

bool strokeSummed(QPainter& painter, const Object& object)
{
    const Style& style = object.style;
    const QTransform toDevice = painter.transform();
    const double scale = std::sqrt(std::abs(toDevice.determinant()));
    const Ink ink{*style.stroke, style.width * scale, style.cap, style.join, style.miterLimit};
    std::vector<Polyline> polylines = polylinesOf(object.path, toDevice);
    const double margin = ink.width * std::max(1.0, ink.join == Join::Miter ? ink.miterLimit : 1);
    const auto pixels = pixelsToSum(polylines, margin, painter);
    const auto parts = pixels ? drawnParts(std::move(polylines), style, scale) : std::nullopt;
    if (!parts)
        return false;
    sum(painter, *pixels, FillRule::NonZero, ink.colour, [&](Coverage& coverage) {
        for (const Polyline& part : *parts)
            addStroke(coverage, part, ink);
    });
    return true;
}

} // namespace app
