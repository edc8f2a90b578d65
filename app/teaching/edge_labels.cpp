// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/edge_labels.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/figure_edges.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

using clipping::Edge;
using EdgeTone = FigureLabel::Tone;

constexpr std::array rectangle{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

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

/// "185 mm further": three digits.
QString furtherText(const EdgePlace& place, Edge edge, const TracedLine& tracedLine)
{
    const QString number = shortText(*place.further, 3);
    const QString text =
        tracedLine.unit.isEmpty() ? number : QStringLiteral("%1 %2").arg(number, tracedLine.unit);
    if (clipping::axisOf(edge) == 0)
        return Text::tr("%1 further").arg(text);
    return (place.inward > 0 ? Text::tr("%1 further up") : Text::tr("%1 further down")).arg(text);
}

/// The label of an edge; at the rim along the edge, where there is no room for two lines.
FigureLabel labelOf(Edge edge, const EdgePlace& place, const TracedLine& tracedLine,
                    const StepScene& scene)
{
    const double level = clipping::levelOf(edge, tracedLine.window);
    const bool atRim = place.at == EdgePlace::At::Rim;
    FigureLabel label{
        .tone = scene.edge == edge ? EdgeTone::HighlightedEdge
                : atRim            ? EdgeTone::RimEdge
                                   : EdgeTone::Edge,
        .head = QStringLiteral("%1 = %2").arg(QLatin1StringView(nameOf(edge)), shortText(level))};
    if (!atRim)
        return label;
    label.layout =
        clipping::axisOf(edge) == 0 ? FigureLabel::Layout::Column : FigureLabel::Layout::Row;
    if (place.further)
        label.detail = furtherText(place, edge, tracedLine);
    return label;
}

/// Whether an edge's label is outside the window at first: above the line, or at its left.
bool isBeforeLine(Edge edge, YAxis y)
{
    return edge == Edge::Left || edge == (y == YAxis::Up ? Edge::Top : Edge::Bottom);
}

/// Labels an edge at the rim, on no other edge: in a row along it or in two lines, beside the side
/// itself or beside its infinite line, or with the value alone, whatever finds room first.
bool labelRim(std::vector<FigureLabel>& labels, const FigureLabel& row, const QLineF& side,
              const QLineF& line, bool before, LabelObstacles& obstacles, const FigureFrame& frame)
{
    FigureLabel stacked = row, value = row;
    stacked.layout = FigureLabel::Layout::Stacked;
    value.detail.clear();
    const auto place = [&](const FigureLabel& label, const QLineF& beside) {
        auto places = placesAlong(beside, sizeOf(label, frame), frame.unit(), before);
        std::erase_if(places, [&](const QRectF& box) { return covers(box, obstacles.avoided); });
        return placeLabel(labels, label, places, obstacles);
    };
    return place(row, side) || place(stacked, side) || place(row, line) || place(stacked, line)
           || place(value, side);
}

void labelRectangle(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                    const StepScene& scene, LabelObstacles& obstacles, const FigureFrame& frame)
{
    const FigureEdges edges(tracedLine, frame);
    for (const Edge edge : rectangle) {
        const auto line = edges.line(edge);
        if (!line)
            continue;
        const FigureLabel label = labelOf(edge, edges[edge], tracedLine, scene);
        const bool before = isBeforeLine(edge, frame.y);
        const auto side = edges.side(edge);
        if (edges[edge].at == EdgePlace::At::Rim && side
            && labelRim(labels, label, *side, *line, before, obstacles, frame))
            continue;
        placeLabel(labels, label, placesAlong(*line, sizeOf(label, frame), frame.unit(), before),
                   obstacles);
    }
}

/// The window in the picture; a line or a point if it has no size. If it is larger than the
/// picture, its part in the room for labels.
QRectF windowBox(const TracedLine& tracedLine, const QRectF& room, const FigureFrame& frame)
{
    const QRectF box =
        tracedLine.corners.empty()
            ? FigureEdges(tracedLine, frame).window()
            : QRectF(frame.at(tracedLine.window.min), frame.at(tracedLine.window.max)).normalized();
    return frame.picture().contains(box) || !room.intersects(box) ? box : box & room;
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
        const FigureLabel label{.tone = now ? EdgeTone::HighlightedEdge : EdgeTone::Edge,
                                .head = Text::tr("edge %1").arg(i + 1)};
        placeLabel(labels, label, placesBesideSide(*side, sizeOf(label, frame), frame.unit()),
                   obstacles);
    }
}

/// Labels the window in one of its corners, otherwise outside at a corner.
void labelWindow(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                 LabelObstacles& obstacles, const FigureFrame& frame)
{
    const QRectF box = windowBox(tracedLine, obstacles.inside, frame);
    const double gap = 3 * frame.unit();
    FigureLabel label{.tone = EdgeTone::Window,
                      .head = tracedLine.windowIsPage ? Text::tr("Page") : Text::tr("Clip window")};
    if (!tracedLine.corners.empty() && obstacles.avoided.empty())
        label.detail = Text::tr("no edge is in sight");
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

std::vector<QLineF> drawnEdges(const TracedLine& tracedLine, const FigureFrame& frame)
{
    std::vector<QLineF> lines;
    const auto& corners = tracedLine.corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (const auto side = frame.part(polygonEdge(i + 1, corners)))
            lines.push_back(*side);
    if (!corners.empty())
        return lines;
    const FigureEdges places(tracedLine, frame);
    for (const Edge edge : rectangle)
        if (const auto line = places.line(edge))
            lines.push_back(*line);
    return lines;
}

void labelEdges(std::vector<FigureLabel>& labels, const TracedLine& tracedLine,
                const StepScene& scene, LabelObstacles& obstacles, const FigureFrame& frame)
{
    if (tracedLine.corners.empty())
        labelRectangle(labels, tracedLine, scene, obstacles, frame);
    else
        labelPolygonEdges(labels, tracedLine, scene, obstacles, frame);
    labelWindow(labels, tracedLine, obstacles, frame);
}

} // namespace app
