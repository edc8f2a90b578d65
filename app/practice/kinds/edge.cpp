// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/practice/kinds/kinds.h"
#include "app/teaching/sentences/words.h"
#include "clipping/outcode.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

using clipping::Edge;

constexpr std::array allEdges{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

bool isBeyond(const Point& p, Edge edge, const clipping::Window& window)
{
    return clipping::outcodeOf(p, window) >> (unsigned(edge) - 1) & 1U;
}

/// Which of the edges that an end is beyond is taken: the first tested, or the one that the slope
/// decides, as in Nicholl-Lee-Nicholl.
bool slopeDecides(const MoveContext& context)
{
    return context.tracedLine.variant.algorithm->abbreviation == std::string_view("NLN");
}

void addMistakesOfCuts(Move& move, const MoveContext& context, int end)
{
    const TracedLine& traced = context.tracedLine;
    const Point p = context.endBefore(end);
    for (const Edge edge : allEdges) {
        const QString words = edgeWords(edge, traced.y);
        if (!isBeyond(p, edge, traced.window))
            addMistake(move, "not-beyond", double(edge),
                       Text::tr("End %1, at %2, is not beyond %3: an end is cut only at an edge "
                                "that it is beyond.")
                           .arg(end)
                           .arg(words::point(p), words));
        else if (slopeDecides(context))
            addMistake(move, "corner", double(edge),
                       Text::tr("End %1 is beyond %2, too, but the line crosses another edge "
                                "before. On which side of the corner does it pass?")
                           .arg(end)
                           .arg(words));
        else
            addMistake(move, "order", double(edge),
                       Text::tr("End %1 is beyond %2, too. Read the pseudo-code from above: which "
                                "of the two edges does it test first?")
                           .arg(end)
                           .arg(words));
    }
}

std::optional<Move> cutMove(const MoveContext& context)
{
    const auto cut = context.nextCut();
    const auto end = cut ? context.movedEnd(*cut) : std::nullopt;
    if (!end || context.narration.steps[*cut].edge == Edge::NoEdge)
        return std::nullopt;
    const Edge edge = context.narration.steps[*cut].edge;
    const Point p = context.endBefore(*end);
    const TracedLine& traced = context.tracedLine;
    Move move{.prompt = Text::tr("End %1 is at %2. At which edge is it cut next?")
                            .arg(*end)
                            .arg(words::point(p)),
              .brief = Text::tr("Edge that cuts End %1").arg(*end),
              .right = double(edge),
              .hint =
                  Text::tr("Follow the tests of the pseudo-code in their order, with the numbers "
                           "of End %1.")
                      .arg(*end)};
    move.reason = Text::tr("End %1 is %2: %3. It is cut at %4.")
                      .arg(*end)
                      .arg(words::beyond(edge, traced.y), words::compared(p, edge, traced.window),
                           edgeWords(edge, traced.y));
    addMistakesOfCuts(move, context, *end);
    return move;
}

/// Skala's numbers of the edges.
constexpr std::array numbered{Edge::Bottom, Edge::Right, Edge::Top, Edge::Left};

std::optional<Move> numberedMove(const MoveContext& context)
{
    const auto value = [&](std::string_view name) -> std::optional<Edge> {
        const auto& values = context.traced().values;
        const auto found = std::ranges::find(values, name, &clipping::NamedValue::name);
        return found == values.end() || found->value < 0 || found->value > 3
                   ? std::nullopt
                   : std::optional(numbered.at(std::size_t(found->value)));
    };
    const std::string_view name = context.planned.variable, otherName = name == "i" ? "j" : "i";
    const auto edge = value(name), other = value(otherName);
    if (!edge)
        return std::nullopt;
    const YAxis y = context.tracedLine.y;
    const QString numbers = Text::tr("Edge 0 is at ymin, edge 1 at xmax, edge 2 at ymax and edge 3 "
                                     "at xmin.");
    Move move{.name = latin(name),
              .prompt = Text::tr("Look c up in the table of the pseudo-code. Which edge has the "
                                 "number %1?")
                            .arg(latin(name)),
              .brief = Text::tr("Edge number %1").arg(latin(name)),
              .right = double(*edge),
              .hint = numbers};
    move.reason = Text::tr("%1 = %2: that is %3.")
                      .arg(latin(name))
                      .arg(std::ranges::find(numbered, *edge) - numbered.begin())
                      .arg(edgeWords(*edge, y));
    if (other)
        addMistake(move, "swapped", double(*other),
                   Text::tr("That is the edge with the number %1. Read the other column of the "
                            "table.")
                       .arg(latin(otherName)));
    for (const Edge wrong : numbered)
        addMistake(move, "not-cut", double(wrong),
                   Text::tr("The line does not pass through that edge between two corners with "
                            "different bits. ")
                       + numbers);
    return move;
}

std::optional<Move> makeEdge(const MoveContext& context)
{
    auto move = context.planned.variable.empty() ? cutMove(context) : numberedMove(context);
    if (move)
        move->chance = 1.0 / 4;
    return move;
}

QString edgeText(const Move&, double answer, YAxis y) { return edgeWords(Edge(int(answer)), y); }

} // namespace

const MoveMaker edgeMaker{MoveKind::Edge, makeEdge, edgeText,
                          QT_TRANSLATE_NOOP("Text", "You can also click it in the figure.")};

} // namespace app
