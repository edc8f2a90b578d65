// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "app/overlays/polygon_edges.h"

// The overlay of every algorithm at a convex polygon: the lines of its edges, and where they cut.

namespace app {

namespace {

/// The lines of more edges would cover the drawing.
constexpr std::size_t mostEdges = 16;

struct PolygonCut {
    bool ofB;
    std::size_t edge;
    Point from, to;
};

std::vector<PolygonCut> cutsOf(const OverlayContext& context)
{
    std::vector<PolygonCut> cuts;
    if (!context.line || context.trace.outcome != clipping::Outcome::Visible)
        return cuts;
    const auto& [a, b] = context.trace.visible;
    for (const auto& [ofB, from, to] :
         {std::tuple(false, context.line->a, a), std::tuple(true, context.line->b, b)})
        if (from != to)
            cuts.push_back({ofB, polygonEdgeAt(to, context.corners), from, to});
    return cuts;
}

QString edgeText(std::size_t number) { return Text::tr("edge %1").arg(number); }

/// The infinite lines of the edges; those that cut the line are highlighted.
std::vector<OverlayLine> polygonEdges(const OverlayContext& context,
                                      std::span<const PolygonCut> cuts)
{
    std::vector<OverlayLine> lines;
    for (std::size_t number = 1; number <= context.corners.size(); ++number) {
        const bool isCut = std::ranges::find(cuts, number, &PolygonCut::edge) != cuts.end();
        const auto line = polygonEdgeLine(number, context.corners, context.seen);
        if (!line || (context.corners.size() > mostEdges && !isCut))
            continue;
        const auto [from, to] = polygonEdge(number, context.corners);
        const Point along = to - from; // the polygon is on its left, with y up
        lines.push_back({.segment = *line,
                         .label = edgeText(number),
                         .outwards = {along.y, -along.x},
                         .emphasis = isCut ? Emphasis::Highlighted : Emphasis::Quiet});
    }
    return lines;
}

QString polygonCaption(const OverlayContext& context, std::span<const PolygonCut> cuts)
{
    if (!context.line)
        return Text::tr("The lines of the window's %1 edges. %2")
            .arg(context.corners.size())
            .arg(pointAtALine());
    const QString name = latin(context.variant.algorithm->name);
    if (context.trace.outcome != clipping::Outcome::Visible)
        return Text::tr("%1 rejects the line: nothing is visible.").arg(name);
    if (cuts.empty())
        return Text::tr("%1 cuts nothing: the whole line is visible.").arg(name);
    return cuts.size() == 1
               ? Text::tr("%1 cuts the line at %2: the remaining part is visible.")
                     .arg(name, edgeText(cuts[0].edge))
               : Text::tr("%1 cuts the line at %2 and %3: the remaining part is visible.")
                     .arg(name, edgeText(cuts[0].edge), edgeText(cuts[1].edge));
}

} // namespace

Overlay polygonOverlay(const OverlayContext& context)
{
    const auto cuts = cutsOf(context);
    Overlay overlay{.lines = polygonEdges(context, cuts), .caption = polygonCaption(context, cuts)};
    for (const auto& [ofB, edge, from, to] : cuts) {
        if (const auto part = clipping::exactAlgorithm().corrected.clip({from, to}, context.seen))
            overlay.lines.push_back({.segment = *part,
                                     .kind = OverlayLine::Kind::Move,
                                     .emphasis = Emphasis::Highlighted});
        overlay.marks.push_back({.at = to,
                                 .symbol = OverlayMark::Symbol::Diamond,
                                 .label = edgeText(edge),
                                 .emphasis = Emphasis::Highlighted});
    }
    if (context.line)
        for (OverlayMark& mark : endMarks(*context.line, {}, {}))
            overlay.marks.push_back(std::move(mark));
    return overlay;
}

} // namespace app
