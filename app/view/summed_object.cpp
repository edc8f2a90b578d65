// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/summed_object.h"

#include "app/view/caps.h"
#include "app/view/coverage.h"
#include "app/view/long_stroke.h"
#include "app/view/outline.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

constexpr double shortestSummedPattern = 0.1; // device pixels; finer dashes look like plain grey
constexpr double mostDashes = 1e7;            // in a path; a path with more is mostly off the page
constexpr double finerCurves = 4;             // how much finer than Qt curves are flattened
constexpr int pixelsAtATime = 1 << 24;        // these use 128 MB

struct FlatSubpath {
    QPolygonF points; ///< device pixels
    bool closed;
};

std::vector<FlatSubpath> flatSubpathsOf(const Path& path, const QTransform& toDevice)
{
    const QTransform toFiner = toDevice * QTransform::fromScale(finerCurves, finerCurves);
    const QTransform back = QTransform::fromScale(1 / finerCurves, 1 / finerCurves);
    std::vector<FlatSubpath> subpaths;
    for (const Subpath& subpath : path.subpaths()) {
        const QPainterPath alone = painterPath({&subpath, 1}, FillRule::NonZero);
        for (const QPolygonF& points : alone.toSubpathPolygons(toFiner))
            if (points.size() > 1)
                subpaths.push_back({back.map(points), subpath.closed});
    }
    return subpaths;
}

// The pixels of the painter's image that may be covered, if summation takes less time.
std::optional<QRect> pixelsToSum(std::span<const FlatSubpath> subpaths, double margin,
                                 const QPainter& painter)
{
    std::size_t count = 0;
    double height = 0;
    QRectF around;
    for (const FlatSubpath& subpath : subpaths) {
        count += std::size_t(subpath.points.size());
        around |= subpath.points.boundingRect().adjusted(-margin, -margin, margin, margin);
        for (qsizetype i = 1; i < subpath.points.size(); ++i)
            height += std::abs(subpath.points[i].y() - subpath.points[i - 1].y());
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
        painter.drawImage(QPoint(pixels.left(), top), coverage.coloured(rule, colour));
    }
    painter.restore();
}

// The polylines that the pen draws, divided into dashes; empty if there are too many dashes.
std::optional<std::vector<FlatSubpath>> drawnParts(std::vector<FlatSubpath> subpaths,
                                                   const Style& style, double scale)
{
    const double period = scale * std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
    if (!(period >= shortestSummedPattern))
        return subpaths;
    std::vector<double> pattern = style.dashes;
    for (double& length : pattern)
        length *= scale;
    std::vector<FlatSubpath> parts;
    for (const FlatSubpath& subpath : subpaths) {
        double length = 0;
        for (qsizetype i = 1; i < subpath.points.size(); ++i)
            length += QLineF(subpath.points[i - 1], subpath.points[i]).length();
        if (!(length / period < mostDashes))
            return std::nullopt;
        for (const auto& dash : dashes(subpath.points, pattern, style.dashOffset * scale, 0))
            parts.push_back({QPolygonF(QList<QPointF>(dash.begin(), dash.end())), false});
    }
    return parts;
}

void addStroke(Coverage& coverage, const FlatSubpath& part, const StrokeStyle& strokeStyle)
{
    const Polyline polyline{0, std::uint32_t(part.points.size()), part.closed, true, true};
    visitContours({part.points, polyline, strokeStyle}, {}, neverCancelled,
                  [&](std::span<const QPointF> contour) { coverage.add(contour); });
}

} // namespace

bool fillSummed(QPainter& painter, const Object& object)
{
    const auto subpaths = flatSubpathsOf(object.path, painter.transform());
    const auto pixels = pixelsToSum(subpaths, 0, painter);
    if (!pixels)
        return false;
    sum(painter, *pixels, object.style.fillRule, *object.style.fill, [&](Coverage& coverage) {
        for (const FlatSubpath& subpath : subpaths)
            coverage.add(subpath.points);
    });
    return true;
}

bool strokeSummed(QPainter& painter, const Object& object)
{
    const Style& style = object.style;
    const QTransform toDevice = painter.transform();
    const double scale = std::sqrt(std::abs(toDevice.determinant()));
    const StrokeStyle strokeStyle{*style.stroke, style.width * scale, style.cap, style.join,
                                  style.miterLimit};
    std::vector<FlatSubpath> subpaths = flatSubpathsOf(object.path, toDevice);
    const double margin =
        strokeStyle.width
        * std::max(1.0, strokeStyle.join == Join::Miter ? strokeStyle.miterLimit : 1);
    const auto pixels = pixelsToSum(subpaths, margin, painter);
    const auto parts = pixels ? drawnParts(std::move(subpaths), style, scale) : std::nullopt;
    if (!parts)
        return false;
    sum(painter, *pixels, FillRule::NonZero, strokeStyle.colour, [&](Coverage& coverage) {
        for (const FlatSubpath& part : *parts)
            addStroke(coverage, part, strokeStyle);
    });
    return true;
}

} // namespace app
