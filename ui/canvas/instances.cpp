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

bool ownEnds(const app::Chain& chain)
{
    return chain.closed || (chain.capAtStart && chain.capAtEnd);
}

// The outline of a stroke as an area, with joins, and with caps if both ends have one.
QPainterPath outline(std::span<const QPointF> points, const app::Chain& chain, const app::Ink& ink)
{
    QPainterPath line(points.front());
    for (const QPointF& p : points.subspan(1, points.size() - (chain.closed ? 2 : 1)))
        line.lineTo(p);
    if (chain.closed)
        line.closeSubpath();
    QPainterPathStroker stroker;
    stroker.setWidth(ink.width);
    stroker.setMiterLimit(ink.miterLimit);
    stroker.setCapStyle(!ownEnds(chain) || ink.cap == app::Cap::Butt ? Qt::FlatCap
                        : ink.cap == app::Cap::Round                 ? Qt::RoundCap
                                                                     : Qt::SquareCap);
    stroker.setJoinStyle(ink.join == app::Join::Miter   ? Qt::SvgMiterJoin
                         : ink.join == app::Join::Round ? Qt::RoundJoin
                                                        : Qt::BevelJoin);
    return stroker.createStroke(line);
}

class Batching {
public:
    explicit Batching(const glm::dvec2& viewSize) : middle_(viewSize.x / 2, viewSize.y / 2) {}

    void add(const app::Plate& plate, const app::Coat& coat)
    {
        if (!coat.stroke)
            beginArea(coat.fill, coat.rule);
        for (const app::Chain& chain : plate.chainsOf(coat)) {
            const auto points = plate.pointsOf(chain);
            if (!coat.stroke) {
                contour(points);
            } else if (needsOutline(chain, *coat.stroke)) {
                strokeArea(points, chain, *coat.stroke);
            } else {
                stroke(points, chain, *coat.stroke);
            }
        }
        if (!coat.stroke)
            for (const app::Chain& chain : plate.chainsOf(coat))
                edge(plate.pointsOf(chain), coat.fill);
    }

    Batches result;

private:
    // Whether the stroke needs an outline, because instanced quads have round joins and draw
    // translucent joins twice.
    bool needsOutline(const app::Chain& chain, const app::Ink& ink)
    {
        const bool round = ink.join == app::Join::Round && ink.colour.alpha == 255;
        if (chain.count <= 2 || ink.width < joinsShow || round)
            return false;
        outlined_ += chain.count;
        return outlined_ <= mostOutlined;
    }

    // A cap at only one end is a separate area, because within the stroke's area the fill rule
    // could cancel it.
    void strokeArea(std::span<const QPointF> points, const app::Chain& chain, const app::Ink& ink)
    {
        area(outline(points, chain, ink), ink.colour);
        if (ownEnds(chain))
            return;
        const double overlap = ink.colour.alpha == 255 ? 0.5 : 0;
        if (chain.capAtStart)
            area(app::capAt(points[0], points[0] - points[1], ink, overlap), ink.colour);
        if (chain.capAtEnd)
            area(app::capAt(points.back(), points.back() - points[points.size() - 2], ink, overlap),
                 ink.colour);
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

    void stroke(std::span<const QPointF> points, const app::Chain& chain, const app::Ink& ink)
    {
        if (result.batches.empty() || result.batches.back().filled)
            result.batches.push_back({false, std::uint32_t(result.instances.size()), 0});
        const bool overlaps = ink.colour.alpha != 255 || ink.width < roundJoinsShow;
        const std::uint32_t join = overlaps ? Butt : Round; // overlapping round joins would show
        const auto end = [&](bool own) {
            return chain.closed ? join : own ? capOf(ink.cap) : Butt;
        };
        for (std::size_t i = 1; i < points.size(); ++i) {
            const std::uint32_t a = i == 1 ? end(chain.capAtStart) : join;
            const std::uint32_t b = i + 1 == points.size() ? end(chain.capAtEnd) : join;
            const QPointF from = points[i - 1] - middle_, to = points[i] - middle_;
            result.instances.push_back({float(from.x()), float(from.y()), float(to.x()),
                                        float(to.y()), packed(ink.colour), float(ink.width),
                                        a | b << 2});
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
        app::Ink ink;
        ink.colour = colour;
        ink.width = edgeWidth;
        if (colour.alpha == 255)
            stroke(points, {0, std::uint32_t(points.size()), true, false, false}, ink);
    }

    QPointF middle_;
    std::size_t outlined_ = 0;
};

} // namespace

Batches batches(const app::Plate& plate, const glm::dvec2& viewSize)
{
    Batching batching(viewSize);
    for (const app::Coat& coat : plate.coats)
        batching.add(plate, coat);
    return std::move(batching.result);
}

} // namespace ui
