// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"

#include <algorithm>

// The default overlay, for algorithms without their own: computed from the trace only.

namespace app {

namespace {

/// The infinite lines of the four edges; those that cut the line are highlighted.
std::vector<OverlayLine> cutEdges(const OverlayContext& context, std::span<const EndMove> moves)
{
    std::vector<OverlayLine> lines;
    for (const clipping::Edge edge : windowEdges)
        if (auto line = border(edge, context)) {
            line->label = edgeName(edge, context.y);
            if (std::ranges::find(moves, edge, &EndMove::edge) != moves.end())
                line->emphasis = Emphasis::Highlighted;
            lines.push_back(*line);
        }
    return lines;
}

OverlayTable cutsTable(const OverlayContext& context, std::span<const EndMove> moves)
{
    OverlayTable table{{Text::tr("cut"), Text::tr("end and edge")}, {}, {}};
    for (const EndMove& move : moves)
        table.rows.push_back(
            {QString::number(table.rows.size() + 1),
             Text::tr("%1 to %2").arg(endName(move.ofB), edgeName(move.edge, context.y))});
    return table;
}

/// "the left edge, the top edge and the right edge".
QString listed(QStringList edges)
{
    const QString last = edges.takeLast();
    return edges.isEmpty() ? last : Text::tr("%1 and %2").arg(edges.join(Text::tr(", ")), last);
}

QString cutsCaption(const OverlayContext& context, std::span<const EndMove> moves)
{
    if (!context.line)
        return Text::tr("The lines of the window's four edges. %1").arg(pointAtALine());
    const QString name = latin(context.variant.algorithm->name);
    const bool visible = context.trace.outcome == clipping::Outcome::Visible;
    if (context.trace.outcome == clipping::Outcome::DidNotEnd)
        return Text::tr("%1 does not end on this line and is stopped: nothing is visible.")
            .arg(name);
    if (moves.empty() && visible && context.trace.visible != *context.line)
        return Text::tr("%1 cuts the line: the remaining part is visible.").arg(name);
    if (moves.empty())
        return (visible ? Text::tr("%1 cuts nothing: the whole line is visible.")
                        : Text::tr("%1 rejects the line without a cut: nothing is visible."))
            .arg(name);
    QStringList edges;
    for (const EndMove& move : moves)
        if (const QString edge = edgeWords(move.edge, context.y); !edges.contains(edge))
            edges << edge;
    return (visible ? Text::tr("%1 cuts the line at %2: the remaining part is visible.")
                    : Text::tr("%1 cuts the line at %2 and then rejects it: nothing is visible."))
        .arg(name, listed(edges));
}

} // namespace

Overlay traceOverlay(const OverlayContext& context)
{
    std::vector<EndMove> moves;
    if (context.line)
        moves = movesOf(context.trace, *context.line);
    constexpr std::size_t enough = 8; // more marks would hide each other
    if (moves.size() > enough)
        moves.resize(enough);
    Overlay overlay{.lines = cutEdges(context, moves), .caption = cutsCaption(context, moves)};
    if (!context.line)
        return overlay;
    for (OverlayLine& line : moveLines(context, moves))
        overlay.lines.push_back(std::move(line));
    overlay.marks = moveMarks(context, moves);
    for (OverlayMark& mark : endMarks(*context.line, {}, {}))
        overlay.marks.push_back(std::move(mark));
    if (!moves.empty())
        overlay.table = cutsTable(context, moves);
    return overlay;
}

} // namespace app
