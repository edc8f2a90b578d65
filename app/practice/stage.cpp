// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/stage.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr double nearLine = 16; // pixels from the line within which a click means it

const Move* shownMove(const Practice& practice, MoveKind kind)
{
    const Move* move = practice.isOn() && !practice.isPaused() ? practice.move() : nullptr;
    return move && move->kind == kind ? move : nullptr;
}

} // namespace

std::vector<StageAnswer> edgesToPick(const Practice& practice, const FigureFrame& frame)
{
    const Move* move = shownMove(practice, MoveKind::Edge);
    if (!move)
        return {};
    using clipping::Edge;
    static constexpr std::array<std::variant<Edge, clipping::Segment>, 4> edges{
        Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};
    auto answers = answersBeside(edges, practice.tracedLine(), frame);
    const MoveAnswer& given = practice.answerTo(practice.index());
    for (StageAnswer& answer : answers) {
        const double edge = answer.choice + 1;
        if (given.settled() && isRight(*move, edge))
            answer.state = StageAnswer::State::Right;
        else if (std::ranges::count(given.tries, edge) > 0)
            answer.state = StageAnswer::State::Wrong;
    }
    return answers;
}

bool isPlacing(const Practice& practice)
{
    return practice.asks() && shownMove(practice, MoveKind::Place);
}

std::optional<double> placeNear(const QPointF& place, const Practice& practice,
                                const FigureFrame& frame)
{
    const auto& [a, b] = practice.tracedLine().line;
    const QLineF line(frame.at(a), frame.at(b));
    const QPointF along = line.p2() - line.p1();
    const double length = QPointF::dotProduct(along, along);
    if (!(length > 0))
        return std::nullopt;
    const double at = std::clamp(QPointF::dotProduct(place - line.p1(), along) / length, 0.0, 1.0);
    return QLineF(line.pointAt(at), place).length() <= nearLine * frame.unit() ? std::optional(at)
                                                                               : std::nullopt;
}

std::optional<QPointF> markOf(const Practice& practice, const FigureFrame& frame)
{
    const Move* move = shownMove(practice, MoveKind::Place);
    const auto at = !move             ? std::nullopt
                    : practice.asks() ? practice.draft()
                                      : std::optional(move->right);
    if (!at)
        return std::nullopt;
    const auto& [a, b] = practice.tracedLine().line;
    return frame.at(a + *at * (b - a));
}

} // namespace app
