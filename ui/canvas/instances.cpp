// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/instances.h"

#include "app/view/caps.h"

#include <QPainterPathStroker>
#include <QPolygonF>

namespace ui {
namespace {

enum : std::uint32_t { Butt, Round, Square };

constexpr double edgeWidth = 0.5; // pixels
constexpr double joinsShow = 2.5; // pixels of a stroke's width
constexpr double roundJoinsShow = 1.5;
// Limit of the points of strokes that become areas in a draw list.
constexpr std::size_t mostOutlined = 50'000;

std::uint32_t packed(const app::Colour& c)
{
    return std::uint32_t(c.red) | std::uint32_t(c.green) << 8 | std::uint32_t(c.blue) << 16
           | std::uint32_t(c.alpha) << 24;
}

std::uint32_t capOf(app::Cap cap)
{
    return cap == app::Cap::Round ? Round : cap == app::Cap::Square ? Square : Butt;
}

bool ownEnds(const app::Polyline& polyline)
{
    return polyline.closed || (polyline.capAtStart && polyline.capAtEnd);
}

// The outline of a stroke as an area, with joins, and with caps if both ends have one.
QPainterPath outline(std::span<const QPointF> points, const app::Polyline& polyline,
                     const app::StrokeStyle& strokeStyle)
{
    QPainterPath line(points.front());
    for (const QPointF& p : points.subspan(1, points.size() - (polyline.closed ? 2 : 1)))
        line.lineTo(p);
    if (polyline.closed)
        line.closeSubpath();
    QPainterPathStroker stroker;
    stroker.setWidth(strokeStyle.width);
    stroker.setMiterLimit(strokeStyle.miterLimit);
    stroker.setCapStyle(!ownEnds(polyline) || strokeStyle.cap == app::Cap::Butt ? Qt::FlatCap
                        : strokeStyle.cap == app::Cap::Round                    ? Qt::RoundCap
                                                                                : Qt::SquareCap);
    stroker.setJoinStyle(strokeStyle.join == app::Join::Miter   ? Qt::SvgMiterJoin
                         : strokeStyle.join == app::Join::Round ? Qt::RoundJoin
                                                                : Qt::BevelJoin);
    return stroker.createStroke(line);
}

class Batching {
public:
    explicit Batching(const glm::dvec2& viewSize) : middle_(viewSize.x / 2, viewSize.y / 2) {}

    void add(const app::DrawList& drawList, const app::DrawCommand& command)
    {
        if (!command.stroke)
            beginArea(command.fill, command.rule);
        for (const app::Polyline& polyline : drawList.polylinesOf(command)) {
            const auto points = drawList.pointsOf(polyline);
            if (!command.stroke) {
                contour(points);
            } else if (needsOutline(polyline, *command.stroke)) {
                strokeArea(points, polyline, *command.stroke);
            } else {
                stroke(points, polyline, *command.stroke);
            }
        }
        if (!command.stroke)
            for (const app::Polyline& polyline : drawList.polylinesOf(command))
                edge(drawList.pointsOf(polyline), command.fill);
    }

    Batches result;

private:
    // Whether the stroke needs an outline, because instanced quads have round joins and draw
    // translucent joins twice.
    bool needsOutline(const app::Polyline& polyline, const app::StrokeStyle& strokeStyle)
    {
        const bool round = strokeStyle.join == app::Join::Round && strokeStyle.colour.alpha == 255;
        if (polyline.count <= 2 || strokeStyle.width < joinsShow || round)
            return false;
        outlined_ += polyline.count;
        return outlined_ <= mostOutlined;
    }

    // A cap at only one end is a separate area, because within the stroke's area the fill rule
    // could cancel it.
    void strokeArea(std::span<const QPointF> points, const app::Polyline& polyline,
                    const app::StrokeStyle& strokeStyle)
    {
        area(outline(points, polyline, strokeStyle), strokeStyle.colour);
        if (ownEnds(polyline))
            return;
        const double overlap = strokeStyle.colour.alpha == 255 ? 0.5 : 0;
        if (polyline.capAtStart)
            area(app::capAt(points[0], points[0] - points[1], strokeStyle, overlap),
                 strokeStyle.colour);
        if (polyline.capAtEnd)
            area(app::capAt(points.back(), points.back() - points[points.size() - 2], strokeStyle,
                            overlap),
                 strokeStyle.colour);
    }

    void area(const QPainterPath& path, const app::Colour& colour)
    {
        beginArea(colour, app::FillRule::NonZero);
        const auto polygons = path.toSubpathPolygons();
        for (const QPolygonF& polygon : polygons)
            contour(polygon);
        for (const QPolygonF& polygon : polygons)
            edge(polygon, colour);
    }

    void stroke(std::span<const QPointF> points, const app::Polyline& polyline,
                const app::StrokeStyle& strokeStyle)
    {
        if (result.batches.empty() || result.batches.back().filled)
            result.batches.push_back({false, std::uint32_t(result.instances.size()), 0});
        const bool overlaps = strokeStyle.colour.alpha != 255 || strokeStyle.width < roundJoinsShow;
        const std::uint32_t join = overlaps ? Butt : Round; // overlapping round joins would show
        const auto end = [&](bool own) {
            return polyline.closed ? join : own ? capOf(strokeStyle.cap) : Butt;
        };
        for (std::size_t i = 1; i < points.size(); ++i) {
            const std::uint32_t a = i == 1 ? end(polyline.capAtStart) : join;
            const std::uint32_t b = i + 1 == points.size() ? end(polyline.capAtEnd) : join;
            const QPointF from = points[i - 1] - middle_, to = points[i] - middle_;
            result.instances.push_back({float(from.x()), float(from.y()), float(to.x()),
                                        float(to.y()), packed(strokeStyle.colour),
                                        float(strokeStyle.width), a | b << 2});
        }
        result.batches.back().count += std::uint32_t(points.size() - 1);
    }

    void beginArea(const app::Colour& colour, app::FillRule rule)
    {
        result.batches.push_back(
            {true, std::uint32_t(result.contourStarts.size()), 0, colour, rule});
    }

    void contour(std::span<const QPointF> points)
    {
        result.contourStarts.push_back(std::int32_t(result.points.size()));
        result.contourCounts.push_back(std::int32_t(points.size()));
        for (const QPointF& p : points)
            result.points.push_back({float(p.x() - middle_.x()), float(p.y() - middle_.y())});
        ++result.batches.back().count;
    }

    // Adds an opaque area's edge stroke; over a translucent area it would show.
    void edge(std::span<const QPointF> points, const app::Colour& colour)
    {
        app::StrokeStyle strokeStyle;
        strokeStyle.colour = colour;
        strokeStyle.width = edgeWidth;
        if (colour.alpha == 255)
            stroke(points, {0, std::uint32_t(points.size()), true, false, false}, strokeStyle);
    }

    QPointF middle_;
    std::size_t outlined_ = 0;
};

} // namespace

Batches batches(const app::DrawList& drawList, const glm::dvec2& viewSize)
{
    Batching batching(viewSize);
    for (const app::DrawCommand& command : drawList.commands)
        batching.add(drawList, command);
    return std::move(batching.result);
}

} // namespace ui
