// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/paint_drawing.h"

#include "app/formats/painted.h"
#include "app/formats/seen_part.h"
#include "app/view/hairline_run.h"
#include "app/view/image_pixels.h"
#include "app/view/outline.h"
#include "app/view/summed_object.h"

#include <QPainter>

#include <algorithm>
#include <numeric>

namespace app {
namespace {

QColor qtColour(const Colour& c) { return {c.red, c.green, c.blue, c.alpha}; }

Qt::PenCapStyle capOf(Cap cap)
{
    return cap == Cap::Butt ? Qt::FlatCap : cap == Cap::Round ? Qt::RoundCap : Qt::SquareCap;
}

Qt::PenJoinStyle joinOf(Join join)
{
    return join == Join::Miter   ? Qt::SvgMiterJoin
           : join == Join::Round ? Qt::RoundJoin
                                 : Qt::BevelJoin;
}

QPen penOf(const Style& style, double pixelsPerUnit)
{
    QPen pen(qtColour(*style.stroke), style.width, Qt::SolidLine, capOf(style.cap),
             joinOf(style.join));
    pen.setMiterLimit(style.miterLimit);
    constexpr double shortestPattern = 0.1; // pixels; finer dashes look grey and take very long
    const double sum = std::accumulate(style.dashes.begin(), style.dashes.end(), 0.0);
    if (sum * pixelsPerUnit < shortestPattern)
        return pen;
    // Of dashes without length, the caps are visible, which QPainter leaves out.
    const double shortest = style.cap == Cap::Butt ? 0 : 1e-3;
    QList<qreal> pattern; // in stroke widths
    for (int twice = style.dashes.size() % 2 == 0 ? 1 : 2; twice > 0; --twice)
        for (const double dash : style.dashes)
            pattern << std::max(dash / style.width, shortest);
    pen.setDashPattern(pattern);
    pen.setDashOffset(style.dashOffset / style.width);
    return pen;
}

/// The object in pixels, if it is an opaque line that is at most one pixel wide.
std::optional<Hairline> hairlineOf(const Object& object, const QTransform& toPixels,
                                   double pixelsPerUnit)
{
    const Style& style = object.style;
    const double width = style.width * pixelsPerUnit;
    const auto line = object.path.singleLine();
    if (!line || line->a == line->b || style.fill || !style.stroke || style.stroke->alpha != 255
        || !style.dashes.empty() || !(width > 0 && width < 1.001))
        return std::nullopt;
    QLineF seen = toPixels.map(QLineF(line->a.x, line->a.y, line->b.x, line->b.y));
    if (style.cap != Cap::Butt) {
        const QPointF cap = (seen.p2() - seen.p1()) / seen.length() * width / 2;
        seen = {seen.p1() - cap, seen.p2() + cap};
    }
    return Hairline::of(seen.p1(), seen.p2(), width, Cap::Butt);
}

/// Whether a path never leaves its start.
bool isPoint(const Subpath& path)
{
    return std::ranges::all_of(path.segments, [&](const PathSegment& segment) {
        return !segment.curved && segment.to == path.start;
    });
}

/// How strokes and fills with many points are painted: a sum of coverage needs pixels.
enum class On : std::uint8_t { Image, Paper };

void paint(QPainter& painter, const Object& object, double pixelsPerUnit, On on)
{
    const Style& style = object.style;
    const QPainterPath outline = painterPath(object.path, style.fillRule);
    const bool image = on == On::Image;
    if (style.fill && !(image && fillSummed(painter, object)))
        painter.fillPath(outline, qtColour(*style.fill));
    if (!style.stroke || !(style.width > 0))
        return;
    painter.setPen(penOf(style, pixelsPerUnit));
    if (!(image && strokeSummed(painter, object)))
        painter.drawPath(outline);
    if (style.cap == Cap::Butt)
        return;
    for (const Subpath& path : object.path.subpaths()) // of a point only the caps are visible
        if (isPoint(path))
            painter.drawPoint(QPointF(path.start.x, path.start.y));
}

void place(QPainter& painter, const Document& document, double pixelsPerUnit)
{
    const Point corner = paperOf(document.page()).corner;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.scale(pixelsPerUnit, pixelsPerUnit);
    painter.translate(-corner.x, -corner.y);
}

} // namespace

void paintOn(QImage& image, const Document& document, double pixelsPerUnit,
             const std::stop_token& stop)
{
    QPainter painter(&image);
    place(painter, document, pixelsPerUnit);
    HairlineRun hairlines(image);
    const auto paintObject = [&](const Object& object) {
        if (stop.stop_requested())
            return;
        if (const auto line = hairlineOf(object, painter.transform(), pixelsPerUnit))
            return hairlines.add(*line, *object.style.stroke);
        hairlines.flush();
        paint(painter, object, pixelsPerUnit, On::Image);
    };
    visitSeen(document, paintObject, [&](const Underlay& underlay) {
        hairlines.flush();
        if (!stop.stop_requested())
            paintUnderlay(painter, underlay);
    });
    hairlines.flush();
}

void paintOn(QPainter& painter, const Document& document, double pixelsPerUnit,
             const std::stop_token& stop)
{
    painter.save();
    place(painter, document, pixelsPerUnit);
    visitSeen(
        document,
        [&](const Object& object) {
            if (!stop.stop_requested())
                paint(painter, object, pixelsPerUnit, On::Paper);
        },
        [&](const Underlay& underlay) {
            if (!stop.stop_requested())
                paintUnderlay(painter, underlay);
        });
    painter.restore();
}

} // namespace app
