// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/overlays/parts.h"
#include "clipping/outcode.h"

#include <algorithm>
#include <iterator>

namespace app {

using clipping::Edge;

namespace {

/// The tests of `exact`: the edges that the line meets first and last on each axis, and whether it
/// has to cross them.
struct Way {
    Edge near[2], far[2];
    bool enters[2], leaves[2];
};
Way wayOf(const clipping::Segment& s, const clipping::Window& w)
{
    Way way{};
    const unsigned a = clipping::outcodeOf(s.a, w), b = clipping::outcodeOf(s.b, w);
    for (glm::length_t k = 0; k < 2; ++k) {
        const bool up = s.a[k] < s.b[k];
        way.near[k] = up ? clipping::lowerEdge(k) : clipping::upperEdge(k);
        way.far[k] = up ? clipping::upperEdge(k) : clipping::lowerEdge(k);
        way.enters[k] = (a & bitOf(way.near[k])) != 0;
        way.leaves[k] = (b & bitOf(way.far[k])) != 0;
    }
    return way;
}

/// One test: on which side of the line the corner of two edges lies.
struct Question {
    Edge edge[2];
    bool decides; ///< whether the line is visible; else only at which edge it is cut
};
std::vector<Question> questionsOf(const Way& way)
{
    std::vector<Question> questions;
    for (const int k : {0, 1})
        if (way.enters[k] && way.leaves[1 - k])
            questions.push_back(
                {{k == 0 ? way.near[0] : way.far[0], k == 0 ? way.far[1] : way.near[1]}, true});
    if (way.enters[0] && way.enters[1])
        questions.push_back({{way.near[0], way.near[1]}, false});
    if (way.leaves[0] && way.leaves[1])
        questions.push_back({{way.far[0], way.far[1]}, false});
    return questions;
}

Point cornerOf(const Question& question, const clipping::Window& w)
{
    return {clipping::levelOf(question.edge[0], w), clipping::levelOf(question.edge[1], w)};
}

/// The far edge of the corner that the line passes on the outside; None: of no corner. The test of
/// that corner is the last one before the line is rejected.
Edge edgeOfRejection(const clipping::Trace& trace)
{
    if (trace.outcome == clipping::Outcome::Visible || trace.steps.size() < 2)
        return Edge::NoEdge;
    return trace.steps[trace.steps.size() - 2].edge;
}

QString turnsCaption(const OverlayContext& context, std::span<const EndMove> moves,
                     std::size_t questions)
{
    if (!context.line)
        return Text::tr(
                   "Only the corners that can decide are tested: on which side of the line do they "
                   "lie? %1")
            .arg(pointAtALine());
    const auto [a, b] = codesOf(context);
    if ((a & b) != 0 || (a | b) == 0)
        return (a & b) != 0 ? Text::tr(
                   "Both ends are beyond one edge: nothing is visible, and no corner is tested.")
                            : Text::tr(
                                "Both ends are inside: nothing is cut, and no corner is tested.");
    if (context.trace.outcome != clipping::Outcome::Visible)
        return Text::tr("The line passes a corner on the outside: nothing is visible.");
    QStringList ways;
    for (const EndMove& move : moves)
        ways << (move.ofB ? Text::tr("leaves through %1") : Text::tr("enters through %1"))
                    .arg(edgeWords(move.edge, context.y));
    const QString asked =
        questions == 0 ? Text::tr("No corner has to be tested") : Text::tr("The corners decide");
    return Text::tr("%1: the line %2.").arg(asked, ways.join(Text::tr(" and ")));
}

/// "left, not top": at which of two edges the line enters or leaves.
QString choiceWords(const Question& question, std::span<const EndMove> moves, YAxis y)
{
    for (const EndMove& move : moves)
        for (const int k : {0, 1})
            if (move.edge == question.edge[k])
                return Text::tr("%1, not %2")
                    .arg(edgeName(move.edge, y), edgeName(question.edge[1 - k], y));
    return {};
}

/// A mark at every corner that is tested; none after a corner that the line passes on the outside.
std::vector<OverlayMark> corners(const OverlayContext& context, std::span<const EndMove> moves)
{
    using Symbol = OverlayMark::Symbol;
    const Edge rejecting = edgeOfRejection(context.trace);
    std::vector<OverlayMark> marks;
    for (const Question& question : questionsOf(wayOf(*context.line, context.window))) {
        const Point corner = cornerOf(question, context.window);
        const bool missed =
            question.decides
            && std::ranges::find(question.edge, rejecting) != std::end(question.edge);
        marks.push_back({.at = corner,
                         .symbol = missed ? Symbol::Hollow : Symbol::Filled,
                         .label = missed             ? Text::tr("passed outside: missed")
                                  : question.decides ? Text::tr("passed inside: met")
                                                     : choiceWords(question, moves, context.y),
                         .emphasis = Emphasis::Highlighted});
        if (missed)
            break;
    }
    return marks;
}

} // namespace

Overlay turnOverlay(const OverlayContext& context)
{
    Overlay overlay{.areas = outcodeRegions(context), .lines = regionBorders(context)};
    std::vector<EndMove> moves;
    if (context.line) {
        moves = movesOf(context.trace, *context.line);
        if (const auto [a, b] = codesOf(context); (a & b) == 0)
            overlay.marks = corners(context, moves);
    }
    overlay.caption = turnsCaption(context, moves, overlay.marks.size());
    if (context.line) {
        for (OverlayMark& mark : moveMarks(context, moves))
            overlay.marks.push_back(std::move(mark));
        for (OverlayMark& mark : endMarks(*context.line, {}, {}))
            overlay.marks.push_back(std::move(mark));
    }
    return overlay;
}

} // namespace app
