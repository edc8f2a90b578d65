// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"

namespace app {

using clipping::Edge;

namespace {

/// C, L, R, B, T and two letters at the corners, as in the authors' table: they mean xmin, xmax,
/// ymin and ymax, whichever direction y has.
QString regionName(unsigned code)
{
    QString name;
    for (const Edge edge : windowEdges)
        if (code & bitOf(edge))
            name += edgeLetter(edge, YAxis::Up);
    return name.isEmpty() ? QStringLiteral("C") : name;
}

OverlayTable scriptsTable(const OverlayContext& context, std::span<const EndMove> moves)
{
    const auto [a, b] = codesOf(context);
    OverlayTable table{
        {Text::tr("case"), Text::tr("%1 to %2").arg(regionName(a), regionName(b))}, {}, {}};
    for (const EndMove& move : moves)
        table.rows.push_back(
            {QString::number(table.rows.size() + 1),
             Text::tr("%1 to %2").arg(endName(move.ofB), edgeName(move.edge, context.y))});
    const bool visible = context.trace.outcome == clipping::Outcome::Visible;
    table.rows.push_back({{}, visible ? Text::tr("visible") : Text::tr("rejected")});
    table.highlightedRow = table.rows.size() - 1;
    return table;
}

QString scriptsCaption(const OverlayContext& context)
{
    if (!context.line)
        return Text::tr("The regions of both ends pick one of 81 scripts. %1").arg(pointAtALine());
    const auto [a, b] = codesOf(context);
    const QString pair = Text::tr("End 1 in %1, End 2 in %2").arg(regionName(a), regionName(b));
    if ((a & b) != 0)
        return Text::tr("%1: the script of this case rejects at once.").arg(pair);
    if ((a | b) == 0)
        return Text::tr("%1: the script of this case is empty, the line is inside.").arg(pair);
    return context.trace.outcome == clipping::Outcome::Visible
               ? Text::tr("%1: the script of this case leaves a visible part.").arg(pair)
               : Text::tr("%1: the script of this case finds that nothing is visible.").arg(pair);
}

} // namespace

Overlay scriptOverlay(const OverlayContext& context)
{
    Overlay overlay{
        .areas = regionsNamed(context, [](unsigned code, YAxis) { return regionName(code); }),
        .lines = regionBorders(context),
        .caption = scriptsCaption(context)};
    if (!context.line)
        return overlay;
    const auto [a, b] = codesOf(context);
    for (OverlayArea& area : overlay.areas)
        if (area.label == regionName(a) || area.label == regionName(b))
            area.emphasis = Emphasis::Highlighted;
    const auto moves = movesOf(context.trace, *context.line);
    for (OverlayLine& line : moveLines(context, moves))
        overlay.lines.push_back(std::move(line));
    overlay.marks = moveMarks(context, moves);
    for (OverlayMark& mark : endMarks(*context.line, regionName(a), regionName(b)))
        overlay.marks.push_back(std::move(mark));
    overlay.table = scriptsTable(context, moves);
    return overlay;
}

} // namespace app
