// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"

#include <algorithm>

namespace app {

using clipping::Edge;

namespace {

/// The tests for an end in that region: first left or right, then those at its new place.
QString testsOf(unsigned code, YAxis y)
{
    QStringList names;
    for (const Edge edge : windowEdges)
        if (code & bitOf(edge))
            names << edgeName(edge, y);
    return names.isEmpty()     ? Text::tr("stays")
           : names.size() == 1 ? names.front()
                               : Text::tr("%1, then %2?").arg(names.front(), names.back());
}

/// The edge perpendicular to an axis to which an end was moved.
QString pushedTo(std::span<const EndMove> moves, bool ofB, glm::length_t axis, YAxis y)
{
    const auto move = std::ranges::find_if(
        moves, [&](const EndMove& m) { return m.ofB == ofB && clipping::axisOf(m.edge) == axis; });
    return move == moves.end() ? QStringLiteral("\u2013") : edgeName(move->edge, y);
}

OverlayTable pushesTable(const OverlayContext& context, std::span<const EndMove> moves)
{
    OverlayTable table{{Text::tr("pushed to"), endName(false), endName(true)}, {}, {}};
    const auto row = [&](const QString& name, glm::length_t axis) {
        table.rows.push_back({name, pushedTo(moves, false, axis, context.y),
                              pushedTo(moves, true, axis, context.y)});
    };
    row(Text::tr("left or right"), 0);
    row(Text::tr("top or bottom"), 1);
    const bool missed = context.trace.outcome != clipping::Outcome::Visible;
    table.rows.push_back({missed ? Text::tr("rejected") : Text::tr("visible"), {}, {}});
    table.highlightedRow = table.rows.size() - 1;
    return table;
}

QString pushesCaption(const OverlayContext& context, std::span<const EndMove> moves)
{
    if (!context.line)
        return Text::tr("The tests that fire for an end: first left or right, then top or bottom. "
                        "The second is at the place to which the end was pushed. %1")
            .arg(pointAtALine());
    QStringList ways;
    for (const EndMove& move : moves)
        ways << Text::tr("%1 to %2").arg(endName(move.ofB), edgeWords(move.edge, context.y));
    const QString pushed = ways.isEmpty() ? Text::tr("No end is pushed.")
                                          : Text::tr("Pushed: %1.").arg(ways.join(Text::tr(", ")));
    if (context.trace.outcome == clipping::Outcome::Visible)
        return pushed + QStringLiteral(" ") + Text::tr("The remaining part is visible.");
    const Edge last = context.trace.steps.empty() ? Edge::NoEdge : context.trace.steps.back().edge;
    const QString why = last == Edge::NoEdge
                            ? Text::tr("The test for a miss fires: nothing is visible.")
                            : Text::tr("Both ends are beyond %1: nothing is visible.")
                                  .arg(edgeWords(last, context.y));
    return pushed + QStringLiteral(" ") + why;
}

} // namespace

Overlay pushOverlay(const OverlayContext& context)
{
    Overlay overlay{.areas = regionsNamed(context, testsOf), .lines = regionBorders(context)};
    std::vector<EndMove> moves;
    if (context.line) {
        moves = movesOf(context.trace, *context.line);
        for (OverlayLine& line : moveLines(context, moves))
            overlay.lines.push_back(std::move(line));
        overlay.marks = moveMarks(context, moves);
        for (OverlayMark& mark : endMarks(*context.line, {}, {}))
            overlay.marks.push_back(std::move(mark));
        overlay.table = pushesTable(context, moves);
    }
    overlay.caption = pushesCaption(context, moves);
    return overlay;
}

} // namespace app
