// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_marks.h"

#include "app/base/finite.h"
#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using Form = FigureMark::Shape;
using MarkTone = FigureMark::Tone;

/// The direction on screen from one point of the drawing to another; to the right if they are
/// equal.
double angleOf(const Point& from, const Point& to, YAxis y)
{
    Point way = to / 2.0 - from / 2.0;
    way /= std::max({std::abs(way.x), std::abs(way.y), 1e-300});
    return QLineF(0, 0, way.x, y == YAxis::Up ? -way.y : way.y).angle();
}

/// The intersection of a ray from the picture's middle with a rectangle around it.
QPointF onBorder(const QRectF& border, double angle)
{
    const QLineF way = QLineF::fromPolar(1, angle);
    const double x = std::abs(way.dx()) > 0 ? border.width() / 2 / std::abs(way.dx()) : 1e9;
    const double y = std::abs(way.dy()) > 0 ? border.height() / 2 / std::abs(way.dy()) : 1e9;
    return border.center() + std::min(x, y) * QPointF(way.dx(), way.dy());
}

/// The point where a line leaves a rectangle at its second end; empty if it is never inside.
std::optional<QPointF> exitFrom(const QRectF& border, const QLineF& line)
{
    const auto piece = clipping::exactAlgorithm().corrected.clip(
        {{line.x1(), line.y1()}, {line.x2(), line.y2()}},
        {{border.left(), border.top()}, {border.right(), border.bottom()}});
    return piece ? std::optional(QPointF(piece->b.x, piece->b.y)) : std::nullopt;
}

/// Places an end outside the picture as an arrow at the border, on the line if it is visible.
void placeFarEnd(FigureMark& mark, const Point& other, const FigureFrame& frame)
{
    const double inset = 9 * frame.unit();
    const QRectF border = frame.picture().adjusted(inset, inset, -inset, -inset);
    const auto part = frame.part({other, mark.point});
    const auto exit = part ? exitFrom(border, *part) : std::nullopt;
    mark.shape = Form::FarEnd;
    mark.angle =
        angleOf(exit ? other : frame.pointAt(frame.picture().center()), mark.point, frame.y);
    mark.place = exit.value_or(onBorder(border, mark.angle));
}

/// The tone of an end: cut in this step, cut earlier, or unchanged.
MarkTone toneOfEnd(const StepScene& scene, int end)
{
    MarkTone tone = scene.state == StepScene::State::Rejected ? MarkTone::Muted : MarkTone::Strong;
    for (const CutPoint& cut : scene.cuts)
        if (cut.end == end)
            tone = scene.isNow(cut) ? MarkTone::Highlighted : MarkTone::Muted;
    return tone;
}

void addEnds(std::vector<FigureMark>& marks, const TracedLine& tracedLine, const StepScene& scene,
             const FigureFrame& frame)
{
    const auto& [a, b] = tracedLine.line;
    for (const auto& [point, other, end] : {std::tuple(a, b, 1), std::tuple(b, a, 2)}) {
        if (!isFinite(point))
            continue;
        FigureMark mark{.shape = Form::End,
                        .tone = toneOfEnd(scene, end),
                        .point = point,
                        .place = frame.at(point),
                        .angle = 0,
                        .head = Text::tr("End %1").arg(end),
                        .detail = pointText(point)};
        if (a == b)
            mark.head = Text::tr("End 1 and End 2");
        if (!frame.shows(point))
            placeFarEnd(mark, other, frame);
        marks.push_back(mark);
        if (a == b)
            break;
    }
}

QString detailOf(const CutPoint& cut, bool now, const FigureFrame& frame)
{
    const QString edge =
        cut.polygonEdge ? Text::tr("edge %1").arg(cut.polygonEdge) : edgeWords(cut.edge, frame.y);
    if (now)
        return edge.isEmpty() ? Text::tr("new End %1").arg(cut.end)
                              : Text::tr("new End %1 at %2").arg(cut.end).arg(edge);
    if (!frame.countsSteps)
        return edge.isEmpty() ? Text::tr("cut") : Text::tr("cut at %1").arg(edge);
    return edge.isEmpty() ? Text::tr("cut in step %1").arg(cut.step + 1)
                          : Text::tr("cut at %1, step %2").arg(edge).arg(cut.step + 1);
}

void addCuts(std::vector<FigureMark>& marks, const StepScene& scene, const FigureFrame& frame)
{
    constexpr std::size_t mostTold = 4; // of more cuts only the final ones have a label
    for (const CutPoint& cut : scene.cuts) {
        if (!frame.shows(cut.at))
            continue;
        const bool told = cut.stands || scene.cuts.size() <= mostTold;
        const bool strong = cut.stands && scene.state != StepScene::State::Rejected;
        marks.push_back({.shape = Form::Cut,
                         .tone = scene.isNow(cut) ? MarkTone::Highlighted
                                 : strong         ? MarkTone::Strong
                                                  : MarkTone::Muted,
                         .point = cut.at,
                         .place = frame.at(cut.at),
                         .angle = 0,
                         .head = told ? pointText(cut.at) : QString(),
                         .detail = told ? detailOf(cut, scene.isNow(cut), frame) : QString()});
    }
}

} // namespace

double radiusOf(const FigureMark& mark, const FigureFrame& frame)
{
    const bool round = mark.shape == Form::End;
    return frame.unit() * (round ? 5.5 : mark.tone == MarkTone::Highlighted ? 9.5 : 7.5);
}

std::vector<FigureMark> figureMarks(const TracedLine& tracedLine, const StepScene& scene,
                                    const FigureFrame& frame)
{
    std::vector<FigureMark> marks;
    addEnds(marks, tracedLine, scene, frame);
    addCuts(marks, scene, frame);
    if (scene.candidate && frame.shows(*scene.candidate))
        marks.push_back({.shape = Form::Candidate,
                         .tone = MarkTone::Highlighted,
                         .point = *scene.candidate,
                         .place = frame.at(*scene.candidate),
                         .angle = 0,
                         .head = pointText(*scene.candidate),
                         .detail = Text::tr("cut here?")});
    return marks;
}

QString pointText(const Point& point)
{
    return QStringLiteral("%1, %2").arg(shortText(point.x), shortText(point.y));
}

} // namespace app
