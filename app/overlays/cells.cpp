// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/half_plane.h"
#include "app/overlays/parts.h"

#include <algorithm>

namespace app {

using clipping::Edge;

namespace {

constexpr unsigned centre = 4;

/// Slater and Barsky's cell of a point: 3 * row + column, where row 0 is that of ymin. Empty to the
/// right of the window, where the method has no cell.
std::optional<unsigned> cellOf(const Point& p, const clipping::Window& window)
{
    if (p.x > window.max.x)
        return std::nullopt;
    const unsigned row = p.y < window.min.y ? 0 : p.y > window.max.y ? 2 : 1;
    return 3 * row + (p.x < window.min.x ? 0 : 1);
}

OverlayArea cellArea(unsigned cell, const OverlayContext& context)
{
    const auto side = [&](Edge edge) { return beyond(edge, context.window); };
    std::vector<HalfPlane> halves{side(Edge::Right).other()};
    halves.push_back(cell % 3 == 0 ? side(Edge::Left) : side(Edge::Left).other());
    if (cell / 3 == 0)
        halves.push_back(side(Edge::Bottom));
    else if (cell / 3 == 2)
        halves.push_back(side(Edge::Top));
    else {
        halves.push_back(side(Edge::Bottom).other());
        halves.push_back(side(Edge::Top).other());
    }
    return {.corners = common(context.seen, halves), .label = QString::number(cell)};
}

/// The cells that the algorithm visited, in order.
std::vector<unsigned> visited(const OverlayContext& context)
{
    std::vector<unsigned> cells;
    const auto visit = [&](unsigned cell) {
        if (cells.empty() || cells.back() != cell)
            cells.push_back(cell);
    };
    for (const clipping::Step& step : context.trace.steps)
        for (const clipping::NamedValue& value : step.values)
            if (value.name == "c")
                visit(unsigned(value.value));
    if (context.trace.outcome == clipping::Outcome::Visible
        && std::ranges::find(cells, centre) == cells.end())
        visit(centre);
    return cells;
}

QString cellsCaption(const OverlayContext& context, std::span<const unsigned> cells)
{
    if (!context.line)
        return Text::tr("The walk goes from cell to cell, to the right. %1").arg(pointAtALine());
    if (cells.empty())
        return Text::tr("Both ends are beyond one edge: there is no walk, and nothing is visible.");
    QStringList names;
    for (const unsigned cell : cells)
        names << QString::number(cell);
    const QString narration = Text::tr("The walk from the left end: cell %1.")
                                  .arg(names.join(QStringLiteral(" \u2192 ")));
    return narration + QStringLiteral(" ")
           + (context.trace.outcome == clipping::Outcome::Visible
                  ? Text::tr("The part in cell 4 is visible.")
                  : Text::tr("The walk does not reach cell 4: nothing is visible."));
}

} // namespace

Overlay cellOverlay(const OverlayContext& context)
{
    std::vector<unsigned> cells;
    if (context.line)
        cells = visited(context);
    Overlay overlay{.lines = regionBorders(context), .caption = cellsCaption(context, cells)};
    for (const unsigned cell : {0U, 1U, 3U, 4U, 6U, 7U}) {
        OverlayArea area = cellArea(cell, context);
        area.pointed = context.pointer && cellOf(*context.pointer, context.window) == cell;
        if (std::ranges::find(cells, cell) != cells.end())
            area.emphasis = Emphasis::Highlighted;
        overlay.areas.push_back(std::move(area));
    }
    overlay.areas.push_back(
        {.corners = common(context.seen, std::array{beyond(Edge::Right, context.window)}),
         .ground = OverlayArea::Ground::Hatched});
    if (!context.line)
        return overlay;
    const std::vector<EndMove> moves = movesOf(context.trace, *context.line);
    overlay.marks = moveMarks(context, moves);
    for (OverlayMark& mark : endMarks(*context.line, {}, {}))
        overlay.marks.push_back(std::move(mark));
    return overlay;
}

} // namespace app
