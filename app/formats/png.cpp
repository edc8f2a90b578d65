// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/formats/format.h"
#include "app/formats/painted.h"
#include "app/formats/seen_part.h"
#include "app/view/hairline_run.h"
#include "app/view/outline.h"
#include "app/view/summed_object.h"

#include <QBuffer>
#include <QImageWriter>
#include <QPainter>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app {
namespace {

// QPainter paints nothing on larger images, and they need more than 600 MB.
constexpr double mostPixelsOfSide = 32'767, mostPixels = 150e6;
constexpr double millimetresPerInch = 25.4;

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
    QList<qreal> pattern; // in stroke widths
    for (int twice = style.dashes.size() % 2 == 0 ? 1 : 2; twice > 0; --twice)
        for (const double dash : style.dashes)
            pattern << dash / style.width;
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

void paint(QPainter& painter, const Object& object, double pixelsPerUnit)
{
    const Style& style = object.style;
    const QPainterPath outline = painterPath(object.path, style.fillRule);
    if (style.fill && !fillSummed(painter, object))
        painter.fillPath(outline, qtColour(*style.fill));
    if (!style.stroke || !(style.width > 0))
        return;
    painter.setPen(penOf(style, pixelsPerUnit));
    if (!strokeSummed(painter, object))
        painter.drawPath(outline);
    if (style.cap == Cap::Butt)
        return;
    for (const Subpath& path : object.path.subpaths()) // of a point only the caps are visible
        if (path.segments.empty())
            painter.drawPoint(QPointF(path.start.x, path.start.y));
}

std::optional<QString> tooLarge(const Point& pixels, const Point& inches)
{
    const double side = std::max(pixels.x, pixels.y), area = pixels.x * pixels.y;
    if (side <= mostPixelsOfSide && area <= mostPixels)
        return std::nullopt;
    const double fits = std::min(mostPixelsOfSide / std::max(inches.x, inches.y),
                                 std::sqrt(mostPixels / inches.x / inches.y));
    constexpr double mostShown = 1e9;
    const auto number = [](double x) {
        return x <= mostShown ? QString::number(x, 'f', 0) : Text::tr("more than 1,000,000,000");
    };
    return Text::tr(
               "the picture would have %1 × %2 pixels, but at most %3 pixels a side and %4 in all "
               "are possible. Choose %5 dpi or less.")
        .arg(number(pixels.x), number(pixels.y), number(mostPixelsOfSide), number(mostPixels),
             fits >= 1 ? number(std::floor(fits)) : QString::number(fits, 'g', 2));
}

std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    if (auto fault = faultOf(document.page()))
        return fault;
    const Paper paper = paperOf(document.page());
    const Point inches = paper.millimetres / millimetresPerInch;
    const Point pixels = glm::max(Point{1, 1}, glm::round(inches * options.dpi));
    if (auto sentence = tooLarge(pixels, inches))
        return sentence;
    QImage image(int(pixels.x), int(pixels.y), QImage::Format_RGB32);
    if (image.isNull())
        return Text::tr("there is not enough memory for the picture. Choose fewer dpi.");
    image.fill(Qt::white); // white paper
    const int dotsPerMetre = int(std::lround(options.dpi / millimetresPerInch * 1000));
    image.setDotsPerMeterX(dotsPerMetre);
    image.setDotsPerMeterY(dotsPerMetre);

    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    const double scale = options.dpi / millimetresPerInch * paper.millimetresPerUnit;
    painter.scale(scale, scale);
    painter.translate(-paper.corner.x, -paper.corner.y);
    HairlineRun hairlines(image);
    visitSeen(document, [&](const Object& object) {
        if (const auto line = hairlineOf(object, painter.transform(), scale))
            return hairlines.add(*line, *object.style.stroke);
        hairlines.flush();
        paint(painter, object, scale);
    });
    hairlines.flush();
    painter.end();

    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!QImageWriter(&buffer, "png").write(image))
        return Text::tr("there is not enough memory for the picture. Choose fewer dpi.");
    const std::string_view view(bytes.data(), std::size_t(bytes.size()));
    return writeAll(out, view) ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace

Format pngFormat()
{
    return {"png",
            Text::tr("PNG picture"),
            nullptr,
            write,
            Holds::Paths,
            StoresHidden::No,
            Text::tr("%1 pixels a side and %2 in all")
                .arg(countText(std::size_t(mostPixelsOfSide)), countText(std::size_t(mostPixels)))};
}

} // namespace app
