// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/overlays/parts.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

using clipping::Edge;

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Overlay", text); }

/// The tests for an end in that region: first left or right, then those at its new place.
QString testsOf(unsigned code, YAxis y)
{
    QStringList names;
    for (const Edge edge : windowEdges)
        if (code & bitOf(edge))
            names << edgeName(edge, y);
    return names.isEmpty()     ? tr("stays")
           : names.size() == 1 ? names.front()
                               : tr("%1, then %2?").arg(names.front(), names.back());
}

/// The edge perpendicular to an axis to which an end was moved.
QString pushedTo(std::span<const EndMove> moves, bool ofB, glm::length_t axis, YAxis y)
{
    const auto move = std::ranges::find_if(
        moves, [&](const EndMove& m) { return m.ofB == ofB && clipping::axisOf(m.edge) == axis; });
    return move == moves.end() ? QStringLiteral("\u2013") : edgeName(move->edge, y);
}

OverlayTable table(const Seeing& seeing, std::span<const EndMove> moves)
{
    OverlayTable table{{tr("pushed to"), endName(false), endName(true)}, {}, {}};
    const auto row = [&](const QString& name, glm::length_t axis) {
        table.rows.push_back(
            {name, pushedTo(moves, false, axis, seeing.y), pushedTo(moves, true, axis, seeing.y)});
    };
    row(tr("left or right"), 0);
    row(tr("top or bottom"), 1);
    const bool missed = seeing.trace.outcome != clipping::Outcome::Visible;
    table.rows.push_back({missed ? tr("rejected") : tr("visible"), {}, {}});
    table.highlightedRow = table.rows.size() - 1;
    return table;
}

QString caption(const Seeing& seeing, std::span<const EndMove> moves)
{
    if (!seeing.line)
        return tr("The tests that fire for an end: first left or right; then top or bottom, at the "
                  "place to which the end was pushed. %1")
            .arg(pointAtALine());
    QStringList ways;
    for (const EndMove& move : moves)
        ways << tr("%1 to %2").arg(endName(move.ofB), edgeWords(move.edge, seeing.y));
    const QString pushed =
        ways.isEmpty() ? tr("No end is pushed.") : tr("Pushed: %1.").arg(ways.join(tr(", ")));
    if (seeing.trace.outcome == clipping::Outcome::Visible)
        return pushed + QStringLiteral(" ") + tr("The remaining part is visible.");
    const Edge last = seeing.trace.steps.empty() ? Edge::None : seeing.trace.steps.back().edge;
    const QString why =
        last == Edge::None
            ? tr("The test for a miss fires: nothing is visible.")
            : tr("Both ends are beyond %1: nothing is visible.").arg(edgeWords(last, seeing.y));
    return pushed + QStringLiteral(" ") + why;
}

} // namespace

Overlay pushOverlay(const Seeing& seeing)
{
    Overlay overlay{.areas = regionsNamed(seeing, testsOf), .lines = regionBorders(seeing)};
    std::vector<EndMove> moves;
    if (seeing.line) {
        moves = movesOf(seeing.trace, *seeing.line);
        for (OverlayLine& line : moveLines(seeing, moves))
            overlay.lines.push_back(std::move(line));
        overlay.marks = moveMarks(seeing, moves);
        for (OverlayMark& mark : endMarks(*seeing.line, {}, {}))
            overlay.marks.push_back(std::move(mark));
        overlay.table = table(seeing, moves);
    }
    overlay.caption = caption(seeing, moves);
    return overlay;
}

} // namespace app
