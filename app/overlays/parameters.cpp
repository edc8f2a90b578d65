// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/finite.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/overlays/half_plane.h"
#include "app/overlays/parts.h"

#include <algorithm>

namespace app {

using clipping::Edge;

namespace {

/// The intersection of the line with an edge's infinite line.
struct Crossing {
    Edge edge = Edge::NoEdge;
    double t = 0;
    bool enters = false;
    Point at{};
};

/// The parameter that the algorithm computed for an edge; empty if it did not need it.
std::optional<double> found(const clipping::Trace& trace, Edge edge)
{
    for (const clipping::Step& step : trace.steps)
        for (const clipping::NamedValue& value : step.values)
            if (step.edge == edge && (value.name == "r" || value.name == "t"))
                return value.value;
    return std::nullopt;
}

/// Empty if the line is parallel to the edge, or if the intersection is not finite.
std::optional<Crossing> crossing(Edge edge, const OverlayContext& context)
{
    const auto axis = clipping::axisOf(edge);
    const auto& [a, b] = *context.line;
    const Point d = b - a;
    if (d[axis] == 0)
        return std::nullopt;
    const double level = clipping::levelOf(edge, context.window);
    const double t = found(context.trace, edge).value_or((level - a[axis]) / d[axis]);
    Point at = a + t * d;
    at[axis] = level;
    const bool low = edge == clipping::lowerEdge(axis);
    if (!std::isfinite(t) || !isFinite(at))
        return std::nullopt;
    return Crossing{edge, t, low == (d[axis] > 0), at};
}

/// The last entry and the first exit, which bound the visible part. None: an end of the line does.
struct Bounds {
    Edge enter = Edge::NoEdge, leave = Edge::NoEdge;
    double from = 0, to = 1;
    bool has(Edge edge) const { return edge == enter || edge == leave; }
};
Bounds boundsOf(std::span<const Crossing> crossings)
{
    Bounds bounds;
    for (const Crossing& c : crossings)
        if (c.enters && c.t > bounds.from)
            bounds.from = c.t, bounds.enter = c.edge;
        else if (!c.enters && c.t < bounds.to)
            bounds.to = c.t, bounds.leave = c.edge;
    return bounds;
}

/// The edge beyond which the line lies, parallel to it; None if there is none.
Edge shutOut(const OverlayContext& context)
{
    const auto& [a, b] = *context.line;
    for (const Edge edge : windowEdges) {
        const auto axis = clipping::axisOf(edge);
        const double level = clipping::levelOf(edge, context.window);
        if (a[axis] == b[axis]
            && (edge == clipping::lowerEdge(axis) ? a[axis] < level : a[axis] > level))
            return edge;
    }
    return Edge::NoEdge;
}

QString parametersCaption(const OverlayContext& context, const Bounds& bounds)
{
    if (!context.line)
        return Text::tr("The window is the intersection of four half-planes; the outer side of "
                        "each edge is hatched. %1")
            .arg(pointAtALine());
    const auto words = [&](Edge edge) { return edgeWords(edge, context.y); };
    if (const Edge edge = shutOut(context); edge != Edge::NoEdge)
        return Text::tr("The line is parallel to %1 and lies beyond it: nothing is visible.")
            .arg(words(edge));
    const QString start =
        bounds.enter == Edge::NoEdge
            ? Text::tr("The line starts inside all four half-planes")
            : Text::tr("The line enters the last half-plane at t = %1, at %2,")
                  .arg(shortText(bounds.from, parameterDigits), words(bounds.enter));
    const QString stop = bounds.leave == Edge::NoEdge
                             ? Text::tr("leaves none of them before its end")
                             : Text::tr("leaves the first one at t = %1, at %2")
                                   .arg(shortText(bounds.to, parameterDigits), words(bounds.leave));
    const bool whole = bounds.enter == Edge::NoEdge && bounds.leave == Edge::NoEdge;
    const QString end = bounds.from > bounds.to
                            ? Text::tr("The line leaves before it has entered: nothing is visible.")
                        : whole ? Text::tr("The whole line is visible.")
                                : Text::tr("The part in between is visible.");
    return Text::tr("%1 and %2. %3").arg(start, stop, end);
}

void addHalfPlanes(Overlay& overlay, const OverlayContext& context, const Bounds& bounds)
{
    for (const Edge edge : windowEdges)
        if (auto line = border(edge, context)) {
            line->label = edgeName(edge, context.y);
            line->outwards = beyond(edge, context.window).normal;
            line->emphasis = bounds.has(edge) ? Emphasis::Highlighted : Emphasis::Quiet;
            overlay.lines.push_back(*line);
        }
}

} // namespace

Overlay parameterOverlay(const OverlayContext& context)
{
    std::vector<Crossing> crossings;
    if (context.line)
        for (const Edge edge : windowEdges)
            if (const auto found = crossing(edge, context))
                crossings.push_back(*found);
    std::ranges::stable_sort(crossings, {}, &Crossing::t);
    const Bounds bounds = boundsOf(crossings);
    Overlay overlay{.caption = parametersCaption(context, bounds)};
    addHalfPlanes(overlay, context, bounds);
    if (!context.line)
        return overlay;
    OverlayAxis axis{.from = bounds.from, .to = bounds.to};
    if (shutOut(context) != Edge::NoEdge)
        axis.from = 1, axis.to = 0;
    for (const Crossing& c : crossings) {
        const auto emphasis = bounds.has(c.edge) ? Emphasis::Highlighted : Emphasis::Quiet;
        using Symbol = OverlayMark::Symbol;
        overlay.marks.push_back(
            {.at = c.at,
             .symbol = c.enters ? Symbol::Filled : Symbol::Hollow,
             .label = (c.enters ? Text::tr("enters  t = %1") : Text::tr("leaves  t = %1"))
                          .arg(shortText(c.t, parameterDigits)),
             .emphasis = emphasis});
        axis.ticks.push_back({c.t, c.enters, edgeName(c.edge, context.y), emphasis});
    }
    for (OverlayMark& mark : endMarks(*context.line, {}, {}))
        overlay.marks.push_back(std::move(mark));
    overlay.axis = std::move(axis);
    return overlay;
}

} // namespace app
