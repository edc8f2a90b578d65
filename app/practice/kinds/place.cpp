// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/practice/kinds/kinds.h"
#include "app/teaching/sentences/words.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

using clipping::Edge;

constexpr double usualReach = 0.03, leastReach = 0.005; // of the line's length

/// The place of a point of a line along it.
double placeOf(const Point& p, const clipping::Segment& line)
{
    const Point along = line.b - line.a;
    const double length = glm::dot(along, along);
    return length > 0 ? glm::dot(p - line.a, along) / length : 0;
}

struct Crossing {
    Edge edge;
    double place;
};

/// Where the line crosses the lines of the edges other than one.
std::vector<Crossing> crossings(const TracedLine& traced, Edge except)
{
    std::vector<Crossing> all;
    const auto& [a, b] = traced.line;
    for (const Edge edge : {Edge::Left, Edge::Right, Edge::Bottom, Edge::Top}) {
        const auto k = clipping::axisOf(edge);
        const double place = (clipping::levelOf(edge, traced.window) - a[k]) / (b[k] - a[k]);
        if (edge != except && place >= 0 && place <= 1)
            all.push_back({edge, place});
    }
    return all;
}

bool isOnWindow(const Point& p, const clipping::Window& w)
{
    const Point slack = 1e-9 * (w.max - w.min);
    return p.x >= w.min.x - slack.x && p.x <= w.max.x + slack.x && p.y >= w.min.y - slack.y
           && p.y <= w.max.y + slack.y;
}

void addMistakesOfPlaces(Move& move, const TracedLine& traced, Edge edge, int end)
{
    const QString here = edgeWords(edge, traced.y);
    const Point right = traced.line.a + move.right * (traced.line.b - traced.line.a);
    const bool seen = isOnWindow(right, traced.window);
    for (const Crossing& crossing : crossings(traced, edge)) {
        const Point p = traced.line.a + crossing.place * (traced.line.b - traced.line.a);
        if (!seen && isOnWindow(p, traced.window))
            addMistake(
                move, "on-window", crossing.place,
                Text::tr("There the line meets the window. The cut at %1 lies where it meets "
                         "the straight line through that edge, and that can be outside the "
                         "window.")
                    .arg(here));
        else
            addMistake(move, "wrong-edge", crossing.place,
                       Text::tr("There the line crosses %1, or its extension. This cut is at %2.")
                           .arg(edgeWords(crossing.edge, traced.y), here));
    }
    addMistake(move, "other-end", 1 - move.right,
               Text::tr("That is as far from the other end. Places are measured from End 1: there "
                        "it is 0, at End 2 it is 1."));
    addMistake(move, "not-moved", end == 1 ? 0 : 1,
               Text::tr("There End %1 was before. The cut moves it along the line.").arg(end));
}

std::optional<Move> makePlace(const MoveContext& context)
{
    if (context.traced().what == clipping::What::Test)
        return std::nullopt; // its line has the cut, too
    const auto cut = context.nextCut();
    const auto end = cut ? context.movedEnd(*cut) : std::nullopt;
    if (!end || context.narration.steps[*cut].edge == Edge::NoEdge)
        return std::nullopt;
    const TracedLine& traced = context.tracedLine;
    const NarratedStep& step = context.narration.steps[*cut];
    const Point p = *end == 1 ? step.left.a : step.left.b;
    Move move{.prompt = Text::tr("Place the new End %1: where is the cut at %2?")
                            .arg(*end)
                            .arg(edgeWords(step.edge, traced.y)),
              .brief = Text::tr("Cut of End %1").arg(*end),
              .right = placeOf(p, traced.line),
              .hint = Text::tr("Follow the line to the straight line through %1. There is the cut.")
                          .arg(edgeWords(step.edge, traced.y))};
    if (!(move.right >= 0 && move.right <= 1))
        return std::nullopt;
    double gap = 2 * usualReach;
    for (const Crossing& crossing : crossings(traced, step.edge))
        gap = std::min(gap, std::abs(crossing.place - move.right));
    move.within = std::max(gap / 2, leastReach);
    move.chance = 2 * move.within;
    move.reason = Text::tr("The new End %1 is at %2.").arg(*end).arg(words::point(p));
    addMistakesOfPlaces(move, traced, step.edge, *end);
    return move;
}

QString placeText(const Move&, double answer, YAxis)
{
    return Text::tr("at %1 of the way from End 1 to End 2").arg(percentText(answer));
}

} // namespace

const MoveMaker placeMaker{
    MoveKind::Place, makePlace, placeText,
    QT_TRANSLATE_NOOP("Text", "You can also click the place on the line in the figure.")};

} // namespace app
