// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_labels.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/label_places.h"

#include <QFontMetricsF>

#include <algorithm>
#include <array>

namespace app {

namespace {

using clipping::Edge;
using LabelTone = FigureLabel::Tone;

constexpr std::array edges{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

QSizeF sizeOf(const FigureLabel& label, const FigureFrame& frame)
{
    const QFontMetricsF head(headFont(frame, label.tone)), detail(detailFont(frame));
    const double width =
        std::max(head.horizontalAdvance(label.head), detail.horizontalAdvance(label.detail));
    const double height = head.height() + (label.detail.isEmpty() ? 0 : detail.height());
    return QRectF(0, 0, std::ceil(width), std::ceil(height))
        .marginsAdded(paddingOf(frame, label.tone))
        .size();
}

QRectF boxOf(const FigureMark& mark, const FigureFrame& frame)
{
    const double r = radiusOf(mark, frame) + frame.unit();
    return {mark.place.x() - r, mark.place.y() - r, 2 * r, 2 * r};
}

/// The infinite lines of a rectangle's edges, or the sides of a polygon.
std::vector<QLineF> edgeLines(const TracedLine& tracedLine, const FigureFrame& frame)
{
    std::vector<QLineF> lines;
    const auto& corners = tracedLine.corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (const auto side = frame.part(polygonEdge(i + 1, corners)))
            lines.push_back(*side);
    if (corners.empty())
        for (const Edge edge : edges)
            if (const auto line = edgeLine(edge, tracedLine, frame))
                lines.push_back(*line);
    return lines;
}

/// The obstacles before any label is placed: marks, including those of later steps, so that labels
/// keep their places; the line; the infinite lines of the edges.
LabelObstacles obstaclesOf(const TracedLine& tracedLine, const Narration& narration,
                           const StepScene& scene, const FigureFrame& frame)
{
    const double m = 6 * frame.unit();
    LabelObstacles obstacles{frame.picture().adjusted(m, m, -m, -m), {}, {}, {}};
    if (!frame.reserved.isEmpty())
        obstacles.boxes.push_back(frame.reserved);
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        obstacles.boxes.push_back(boxOf(mark, frame));
    if (!narration.steps.empty())
        for (const FigureMark& mark : figureMarks(
                 tracedLine, stepScene(tracedLine, narration, narration.steps.size() - 1), frame))
            obstacles.boxes.push_back(boxOf(mark, frame));
    std::vector<clipping::Segment> lines{tracedLine.line, scene.left};
    lines.insert(lines.end(), scene.discarded.begin(), scene.discarded.end());
    lines.insert(lines.end(), scene.discardedNow.begin(), scene.discardedNow.end());
    for (const auto& line : lines)
        if (const auto part = frame.part(line))
            obstacles.lines.push_back(*part);
    for (const QLineF& line : edgeLines(tracedLine, frame))
        obstacles.avoided.push_back(line);
    return obstacles;
}

/// Puts a label at the best free place, if any, and makes the place an obstacle.
bool placeLabel(std::vector<FigureLabel>& labels, FigureLabel label, std::span<const QRectF> places,
                LabelObstacles& obstacles)
{
    const auto box = freePlace(places, obstacles);
    if (!box)
        return false;
    label.box = *box;
    obstacles.boxes.push_back(*box);
    labels.push_back(std::move(label));
    return true;
}

void labelMark(std::vector<FigureLabel>& labels, const FigureMark& mark, LabelObstacles& obstacles,
               const FigureFrame& frame)
{
    const bool boxed =
        mark.shape == FigureMark::Shape::Cut && mark.tone == FigureMark::Tone::Highlighted;
    FigureLabel label{
        boxed ? LabelTone::Highlighted : LabelTone::Plain, mark.head, mark.detail, {}, {}};
    const QSizeF size = sizeOf(label, frame);
    const double radius = radiusOf(mark, frame);
    if (!placeLabel(labels, label, placesAround(mark.place, radius, size), obstacles)
        && !placeLabel(labels, label, placesWithin(obstacles.inside, mark.place, size), obstacles))
        return;
    FigureLabel& placed = labels.back();
    const QPointF nearest(std::clamp(mark.place.x(), placed.box.left(), placed.box.right()),
                          std::clamp(mark.place.y(), placed.box.top(), placed.box.bottom()));
    if (QLineF(nearest, mark.place).length() > 3.2 * radius)
        placed.leader = mark.place;
}

/// Places beside the ends of an edge's infinite line: at the right and at the bottom first.
std::vector<QRectF> placesAlong(const QLineF& line, const QSizeF& label, double unit, bool before)
{
    const double gap = 2 * unit, inset = 7 * unit; // off the line, and off the border
    std::vector<QRectF> places;
    const bool vertical = std::abs(line.dx()) < std::abs(line.dy());
    const double length = line.length() - (vertical ? label.height() : label.width());
    const QPointF origin(std::min(line.x1(), line.x2()), std::min(line.y1(), line.y2()));
    const double first = before ? -gap - (vertical ? label.width() : label.height()) : gap;
    const double second = before ? gap : -gap - (vertical ? label.width() : label.height());
    for (const double along : {1.0, 0.0, 0.9, 0.1, 0.8, 0.2, 0.7, 0.3, 0.6, 0.4, 0.5})
        for (const double off : {first, second}) {
            const double at = inset + along * (length - 2 * inset);
            places.emplace_back(origin + (vertical ? QPointF(off, at) : QPointF(at, off)), label);
        }
    return places;
}

const char* nameOf(Edge edge)
{
    static constexpr std::array names{"", "xmin", "xmax", "ymin", "ymax"};
    return names[std::size_t(edge)];
}

void labelEdges(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                const StepScene& scene, LabelObstacles& obstacles, const FigureFrame& frame)
{
    for (const Edge edge : edges) {
        const auto line = edgeLine(edge, tracedLine, frame);
        if (!line)
            continue;
        const double level = clipping::levelOf(edge, tracedLine.window);
        const LabelTone tone = scene.edge == edge ? LabelTone::HighlightedEdge : LabelTone::Edge;
        FigureLabel label{
            tone,
            QStringLiteral("%1 = %2").arg(QLatin1StringView(nameOf(edge)), shortText(level)),
            {},
            {},
            {}};
        const bool before =
            edge == Edge::Left || edge == (frame.y == YAxis::Up ? Edge::Top : Edge::Bottom);
        placeLabel(labels, label, placesAlong(*line, sizeOf(label, frame), frame.unit(), before),
                   obstacles);
    }
}

/// The number of an edge, just outside its middle.
std::vector<QRectF> placesBesideSide(const QLineF& side, const QSizeF& label, double unit)
{
    std::vector<QRectF> places;
    const QLineF normal = side.normalVector().unitVector();
    const double half =
        (std::abs(normal.dx()) * label.width() + std::abs(normal.dy()) * label.height()) / 2;
    const double away = 2 * unit + half;
    for (const double along : {0.5, 0.35, 0.65, 0.2, 0.8})
        for (const double sign : {1.0, -1.0}) {
            QRectF place(QPointF(), label);
            place.moveCenter(side.pointAt(along) + sign * away * QPointF(normal.dx(), normal.dy()));
            places.push_back(place);
        }
    return places;
}

/// Numbers the edges of a polygonal window; of many edges only the one of the step.
void labelPolygonEdges(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                       const StepScene& scene, LabelObstacles& obstacles, const FigureFrame& frame)
{
    constexpr std::size_t mostNumbered = 12;
    const auto& corners = tracedLine.corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const bool now = scene.polygonEdge == i + 1;
        const auto side = frame.part(polygonEdge(i + 1, corners));
        if (!side || !(side->length() > 0) || (corners.size() > mostNumbered && !now))
            continue;
        FigureLabel label{now ? LabelTone::HighlightedEdge : LabelTone::Edge,
                          Text::tr("edge %1").arg(i + 1),
                          {},
                          {},
                          {}};
        placeLabel(labels, label, placesBesideSide(*side, sizeOf(label, frame), frame.unit()),
                   obstacles);
    }
}

/// Labels the window in one of its corners, otherwise outside at a corner.
void labelWindow(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                 LabelObstacles& obstacles, const FigureFrame& frame)
{
    const QRectF box = windowBox(tracedLine, frame);
    const double gap = 3 * frame.unit();
    FigureLabel label{LabelTone::Window,
                      tracedLine.windowIsPage ? Text::tr("Page") : Text::tr("Clip window"),
                      {},
                      {},
                      {}};
    const QSizeF size = sizeOf(label, frame);
    std::vector<QRectF> places;
    const double left = box.left() + gap, right = box.right() - gap - size.width();
    const double top = box.top() + gap, bottom = box.bottom() - gap - size.height();
    if (right >= left && bottom >= top)
        for (const QPointF& corner : {QPointF(left, bottom), QPointF(right, bottom),
                                      QPointF(left, top), QPointF(right, top)})
            places.emplace_back(corner, size);
    for (const double y : {box.bottom() + gap, box.top() - gap - size.height()})
        for (const double x : {left, right, box.right() + gap, box.left() - gap - size.width()})
            places.emplace_back(QPointF(x, y), size);
    placeLabel(labels, label, places, obstacles);
}

} // namespace

QFont headFont(const FigureFrame& frame, LabelTone tone)
{
    QFont font = frame.font;
    if (tone == LabelTone::Edge)
        return detailFont(frame);
    font.setWeight(QFont::DemiBold);
    if (tone != LabelTone::Plain && tone != LabelTone::Highlighted)
        font.setPixelSize(detailFont(frame).pixelSize());
    return font;
}

QFont detailFont(const FigureFrame& frame)
{
    QFont font = frame.font;
    font.setPixelSize(std::max(1, qRound(font.pixelSize() * 0.92)));
    return font;
}

QMarginsF paddingOf(const FigureFrame& frame, LabelTone tone)
{
    const double u = frame.unit();
    return tone == LabelTone::Highlighted ? QMarginsF(9, 5, 9, 5) * u : QMarginsF(3, 1, 3, 1) * u;
}

std::optional<QLineF> edgeLine(Edge edge, const TracedLine& tracedLine, const FigureFrame& frame)
{
    const glm::length_t across = clipping::axisOf(edge);
    const double level = clipping::levelOf(edge, tracedLine.window);
    clipping::Segment line{frame.seen.min, frame.seen.max};
    line.a[across] = line.b[across] = level;
    return frame.part(line);
}

QRectF windowBox(const TracedLine& tracedLine, const FigureFrame& frame)
{
    return QRectF(frame.at(tracedLine.window.min), frame.at(tracedLine.window.max)).normalized();
}

std::vector<FigureLabel> figureLabels(const TracedLine& tracedLine, const Narration& narration,
                                      const StepScene& scene, const FigureFrame& frame)
{
    LabelObstacles obstacles = obstaclesOf(tracedLine, narration, scene, frame);
    std::vector<FigureLabel> labels;
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        if (!mark.head.isEmpty())
            labelMark(labels, mark, obstacles, frame);
    if (tracedLine.corners.empty())
        labelEdges(labels, tracedLine, scene, obstacles, frame);
    else
        labelPolygonEdges(labels, tracedLine, scene, obstacles, frame);
    labelWindow(labels, tracedLine, obstacles, frame);
    return labels;
}

} // namespace app
