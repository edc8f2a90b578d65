// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/stage_answers.h"

#include "app/teaching/figure_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double besidePart = 9; // pixels from a part to its disc
constexpr double reach = 8;      // pixels from a part within which a click means it

double distance(const QPointF& place, const QLineF& line)
{
    const QPointF along = line.p2() - line.p1(), to = place - line.p1();
    const double length = QPointF::dotProduct(along, along);
    const double t = length > 0 ? std::clamp(QPointF::dotProduct(to, along) / length, 0.0, 1.0) : 0;
    return QLineF(place, line.pointAt(t)).length();
}

/// Beside the part, outside the window if there is room; not on the line, and not under what is
/// reserved.
QPointF discBeside(const QLineF& part, const QPointF& middle, const std::optional<QLineF>& line,
                   const FigureFrame& frame)
{
    const double radius = discSize / 2 * frame.unit(), gap = besidePart * frame.unit();
    const QLineF normal = part.normalVector().unitVector();
    QPointF out(normal.dx(), normal.dy());
    if (QPointF::dotProduct(out, part.center() - middle) < 0)
        out = -out;
    const auto isFree = [&](const QPointF& disc) {
        const QRectF box = boxOfDisc(disc, frame);
        return frame.picture().contains(box) && !frame.reserved.intersects(box)
               && (!line || distance(disc, *line) > radius + gap);
    };
    constexpr std::array places{0.5, 0.35, 0.65, 0.2, 0.8};
    for (const double side : {1.0, -1.0})
        for (const double place : places)
            if (const QPointF disc = part.pointAt(place) + out * side * (radius + gap);
                isFree(disc))
                return disc;
    return part.pointAt(places[0]) - out * (radius + gap);
}

StageAnswer::State stateOf(int choice, const Course& course)
{
    if (!course.isOpen() && choice == course.question()->right)
        return StageAnswer::State::Right;
    return std::ranges::count(course.answer().tries, choice) > 0 ? StageAnswer::State::Wrong
                                                                 : StageAnswer::State::Open;
}

} // namespace

QRectF boxOfDisc(const QPointF& middle, const FigureFrame& frame)
{
    const double radius = discSize / 2 * frame.unit();
    return {middle - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius)};
}

std::vector<StageAnswer>
answersBeside(std::span<const std::variant<clipping::Edge, clipping::Segment>> parts,
              const TracedLine& tracedLine, const FigureFrame& frame)
{
    const FigureEdges edges(tracedLine, frame);
    const auto line = frame.part(tracedLine.line);
    std::vector<StageAnswer> answers;
    for (const auto& part : parts) {
        const auto* edge = std::get_if<clipping::Edge>(&part);
        const auto side = edge ? edges.side(*edge) : frame.part(std::get<clipping::Segment>(part));
        if (!side)
            return {};
        const QPointF disc =
            discBeside(*side, edges.window().center(), edge ? line : std::nullopt, frame);
        answers.push_back({int(answers.size()), *side, disc});
    }
    return answers;
}

std::vector<StageAnswer> stageAnswers(const Course& course, const FigureFrame& frame)
{
    if (!course.lesson() || course.isPaused() || !course.question() || course.isElsewhere())
        return {};
    auto answers = answersBeside(course.question()->parts, course.asked(), frame);
    for (StageAnswer& answer : answers)
        answer.state = stateOf(answer.choice, course);
    return answers;
}

std::optional<int> answerAt(const std::vector<StageAnswer>& answers, const QPointF& place,
                            const FigureFrame& frame)
{
    for (const StageAnswer& answer : answers)
        if (QLineF(answer.disc, place).length() <= discSize / 2 * frame.unit())
            return answer.choice;
    const auto nearest = std::ranges::min_element(
        answers, {}, [&](const StageAnswer& answer) { return distance(place, answer.part); });
    return nearest != answers.end() && distance(place, nearest->part) <= reach * frame.unit()
               ? std::optional(nearest->choice)
               : std::nullopt;
}

} // namespace app
