// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/half_plane.h"
#include "app/overlays/parts.h"
#include "clipping/outcode.h"

#include <algorithm>

namespace app {

using clipping::Edge;

namespace {

/// The edges at which a line from the first end enters and leaves the window.
struct Sector {
    Edge enter = Edge::NoEdge, leave = Edge::NoEdge;
    friend bool operator==(const Sector&, const Sector&) = default;
};

/// In the notation of Nicholl, Lee and Nicholl: "LT"; inside without a cut: "in".
QString labelOf(const Sector& sector, YAxis y)
{
    const QString text = edgeLetter(sector.enter, y) + edgeLetter(sector.leave, y);
    return text.isEmpty() ? Text::tr("in") : text;
}

/// The sector that the library found; empty if nothing was visible.
std::optional<Sector> sectorOf(const clipping::Trace& trace, const clipping::Segment& line)
{
    if (trace.outcome != clipping::Outcome::Visible)
        return std::nullopt;
    Sector sector;
    for (const EndMove& move : movesOf(trace, line))
        (move.ofB ? sector.leave : sector.enter) = move.edge;
    return sector;
}

/// The division of the plane around the first end.
class Around {
public:
    Around(const Point& eye, const OverlayContext& context) : eye_(eye), context_(context)
    {
        for (const Edge edge : windowEdges)
            if (isBeyond(eye, edge, context.window))
                facing_.push_back(edge);
    }

    std::vector<OverlayArea> sectors() const
    {
        std::vector<OverlayArea> areas = blind();
        const std::vector<Edge> entries = facing_.empty() ? std::vector{Edge::NoEdge} : facing_;
        for (const Edge enter : entries) {
            areas.push_back(sector({enter, Edge::NoEdge}));
            for (const Edge leave : windowEdges)
                if (std::ranges::find(facing_, leave) == facing_.end())
                    areas.push_back(sector({enter, leave}));
        }
        return areas;
    }

    std::vector<OverlayLine> rays() const
    {
        const auto& [min, max] = context_.window;
        static const auto* const ray = clipping::findAlgorithm("liang-barsky")->ray;
        std::vector<OverlayLine> lines;
        for (const Point& corner : {min, Point(max.x, min.y), max, Point(min.x, max.y)})
            if (const auto part = ray->clip({eye_, corner}, context_.seen))
                lines.push_back({.segment = *part, .kind = OverlayLine::Kind::Ray});
        return lines;
    }

private:
    /// Adds the wedge between the rays from the first end through the two corners of an edge.
    void addWedge(std::vector<HalfPlane>& halves, Edge edge) const
    {
        const auto [one, other] = cornersOf(edge, context_.window);
        halves.push_back(sideOf(eye_, one, other));
        halves.push_back(sideOf(eye_, other, one));
    }
    OverlayArea sector(const Sector& of) const
    {
        std::vector<HalfPlane> halves;
        if (of.enter != Edge::NoEdge)
            addWedge(halves, of.enter);
        if (of.leave != Edge::NoEdge) {
            addWedge(halves, of.leave);
            halves.push_back(beyond(of.leave, context_.window));
        } else
            for (const Edge edge : windowEdges)
                halves.push_back(beyond(edge, context_.window).other());
        return {.corners = common(context_.seen, halves), .label = labelOf(of, context_.y)};
    }
    OverlayArea hatched(std::span<const HalfPlane> halves) const
    {
        return {.corners = common(context_.seen, halves), .ground = OverlayArea::Ground::Hatched};
    }
    /// The areas in which a line from the first end ends outside the window: beside it, and in
    /// front.
    std::vector<OverlayArea> blind() const
    {
        std::vector<OverlayArea> areas;
        if (facing_.empty())
            return areas;
        const auto [one, other] = outermost();
        const HalfPlane in = sideOf(eye_, one, other), too = sideOf(eye_, other, one);
        areas.push_back(hatched(std::array{in.other()}));
        areas.push_back(hatched(std::array{in, too.other()}));
        for (const Edge edge : facing_) {
            std::vector<HalfPlane> halves{beyond(edge, context_.window)};
            addWedge(halves, edge);
            areas.push_back(hatched(halves));
        }
        return areas;
    }
    /// The corners that bound the window as seen from the first end: of one edge, or of two
    /// adjacent ones.
    EdgeCorners outermost() const
    {
        const EdgeCorners first = cornersOf(facing_.front(), context_.window);
        if (facing_.size() == 1)
            return first;
        const EdgeCorners second = cornersOf(facing_.back(), context_.window);
        const Point shared =
            first.one == second.one || first.one == second.other ? first.one : first.other;
        return {first.one == shared ? first.other : first.one,
                second.one == shared ? second.other : second.one};
    }

    Point eye_;
    const OverlayContext& context_;
    std::vector<Edge> facing_; ///< the edges that the first end is beyond
};

OverlayArea* areaOf(std::vector<OverlayArea>& areas, const std::optional<Sector>& sector, YAxis y)
{
    if (!sector)
        return nullptr;
    const auto area = std::ranges::find(areas, labelOf(*sector, y), &OverlayArea::label);
    return area == areas.end() ? nullptr : &*area;
}

QString placeWords(const Point& eye, const OverlayContext& context)
{
    const unsigned code = clipping::outcodeOf(eye, context.window);
    return code == 0             ? Text::tr("inside the window")
           : (code & (code - 1)) ? Text::tr("beyond a corner")
                                 : Text::tr("beyond an edge");
}

QString sectorCaption(const OverlayContext& context, const Point& eye,
                      const std::optional<Sector>& sector)
{
    const QString place = placeWords(eye, context);
    if (!context.line)
        return Text::tr("These are the sectors of a line whose End 1 is here, %1. %2")
            .arg(place, pointAtALine());
    if (!sector)
        return Text::tr(
                   "End 1 lies %1, and no line from there to End 2 meets the window: nothing is "
                   "visible.")
            .arg(place);
    if (*sector == Sector{})
        return Text::tr("End 1 lies %1, and so does End 2: nothing is cut.").arg(place);
    const auto words = [&](Edge edge) { return edgeWords(edge, context.y); };
    const QString text = sector->enter == Edge::NoEdge
                             ? Text::tr("the line leaves through %1").arg(words(sector->leave))
                         : sector->leave == Edge::NoEdge
                             ? Text::tr("the line enters through %1").arg(words(sector->enter))
                             : Text::tr("the line enters through %1 and leaves through %2")
                                   .arg(words(sector->enter), words(sector->leave));
    return Text::tr("End 1 lies %1, End 2 in sector %2: %3.")
        .arg(place, labelOf(*sector, context.y), text);
}

} // namespace

Overlay sectorOverlay(const OverlayContext& context)
{
    if (!context.line && !context.pointer)
        return {.areas = outcodeRegions(context),
                .lines = regionBorders(context),
                .caption = pointAtALine()};
    const Point eye = context.line ? context.line->a : *context.pointer;
    const Around around(eye, context);
    Overlay overlay{.areas = around.sectors(), .lines = around.rays()};
    std::optional<Sector> sector;
    if (context.line) {
        sector = sectorOf(context.trace, *context.line);
        if (OverlayArea* area = areaOf(overlay.areas, sector, context.y))
            area->emphasis = Emphasis::Highlighted;
        overlay.marks =
            endMarks(*context.line, {}, sector ? labelOf(*sector, context.y) : QString());
    } else
        overlay.marks.push_back({.at = eye, .label = endName(false)});
    if (context.pointer) {
        const clipping::Segment there{eye, *context.pointer};
        const auto to = sectorOf(context.traceOf(there), there);
        if (OverlayArea* area = areaOf(overlay.areas, to, context.y))
            area->pointed = true;
    }
    overlay.caption = sectorCaption(context, eye, sector);
    return overlay;
}

} // namespace app
