// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/finite.h"
#include "app/overlays/parts.h"

namespace app {

namespace {

/// The visible part of a line; rounding may put its ends just outside.
std::optional<clipping::Segment> seenPart(const Point& from, const Point& to,
                                          const clipping::Window& seen)
{
    return clipping::exactAlgorithm().corrected.clip({from, to}, seen);
}

} // namespace

std::vector<EndMove> movesOf(const clipping::Trace& trace, const clipping::Segment& line)
{
    std::vector<EndMove> moves;
    clipping::Segment before = line;
    const auto note = [&](bool ofB, clipping::Edge edge, const Point& from, const Point& to) {
        if (from == to)
            return;
        if (!moves.empty() && moves.back().ofB == ofB && moves.back().edge == edge)
            moves.back().to = to;
        else
            moves.push_back({ofB, edge, from, to});
    };
    for (const clipping::Step& step : trace.steps) {
        if (step.edge != clipping::Edge::NoEdge) {
            note(false, step.edge, before.a, step.segment.a);
            note(true, step.edge, before.b, step.segment.b);
        }
        before = step.segment;
    }
    return moves;
}

std::vector<OverlayLine> moveLines(const OverlayContext& context, std::span<const EndMove> moves)
{
    std::vector<OverlayLine> lines;
    for (const EndMove& move : moves)
        if (const auto part = seenPart(move.from, move.to, context.seen))
            lines.push_back({.segment = *part,
                             .kind = OverlayLine::Kind::Move,
                             .emphasis = Emphasis::Highlighted});
    return lines;
}

std::vector<OverlayMark> moveMarks(const OverlayContext& context, std::span<const EndMove> moves)
{
    std::vector<OverlayMark> marks;
    for (const EndMove& move : moves) {
        if (!isFinite(move.to)) // of a misprint
            continue;
        marks.push_back(
            {.at = move.to,
             .symbol = OverlayMark::Symbol::Diamond,
             .label =
                 QStringLiteral("%1  %2").arg(marks.size() + 1).arg(edgeName(move.edge, context.y)),
             .emphasis = Emphasis::Highlighted});
    }
    return marks;
}

} // namespace app
