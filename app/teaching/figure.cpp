// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure.h"

#include "app/overlays/half_plane.h"
#include "app/overlays/label_places.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/figure_labels.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>

#include <array>

namespace app {

namespace {

using clipping::Edge;

/// The data for painting every part of a figure.
struct Picture {
    QPainter& painter;
    const TracedLine& tracedLine;
    const StepScene& scene;
    const FigureFrame& frame;
    const FigureColours& colours;
    double u; ///< the unit of strokes
};

QPen pen(const QColor& colour, double width, Qt::PenCapStyle cap = Qt::FlatCap)
{
    return {colour, width, Qt::SolidLine, cap, Qt::MiterJoin};
}

QPen dashed(const QColor& colour, double width)
{
    QPen dashes = pen(colour, width);
    dashes.setDashPattern({3.2, 2.4});
    return dashes;
}

void strike(const Picture& s, const clipping::Segment& line, const QPen& with)
{
    if (const auto part = s.frame.part(line)) {
        s.painter.setPen(with);
        s.painter.drawLine(*part);
    }
}

/// The part of the picture beyond an edge; empty if there is none.
QRectF beyond(const Picture& s, Edge edge)
{
    const QRectF all = s.frame.picture();
    const double level = clipping::levelOf(edge, s.tracedLine.window);
    const QPointF place = s.frame.at({level, level});
    const bool lower = edge == clipping::lowerEdge(clipping::axisOf(edge));
    QRectF part = all;
    if (clipping::axisOf(edge) == 0)
        lower ? part.setRight(place.x()) : part.setLeft(place.x());
    else if (lower == (s.frame.y == YAxis::Down))
        part.setBottom(place.y());
    else
        part.setTop(place.y());
    return part.isValid() ? part & all : QRectF();
}

/// Thin slanted lines; a brush's pattern would differ in size between a window and a file.
void hatch(const Picture& s, const QRectF& area)
{
    if (area.isEmpty())
        return;
    QColor quiet = s.colours.rule;
    quiet.setAlphaF(0.7F);
    s.painter.setPen(pen(quiet, s.u));
    for (const QLineF& line : hatching(area, 9 * s.u))
        s.painter.drawLine(line);
}

/// Hatches what lies beyond the line of a side.
void hatchBeyondSide(const Picture& s, std::size_t number)
{
    const auto [from, to] = polygonEdge(number, s.tracedLine.corners);
    const Point along = to - from;
    QPolygonF area;
    for (const Point& p : common(s.frame.seen, std::array{HalfPlane{from, {along.y, -along.x}}}))
        area << s.frame.at(p);
    QPainterPath path;
    path.addPolygon(area);
    s.painter.save();
    s.painter.setClipPath(path);
    hatch(s, area.boundingRect());
    s.painter.restore();
}

void paintPolygon(const Picture& s)
{
    for (std::size_t i = 1; i <= s.tracedLine.corners.size(); ++i)
        strike(s, polygonEdge(i, s.tracedLine.corners),
               pen(s.colours.window, 2 * s.u, Qt::RoundCap));
}

void paintWindow(const Picture& s)
{
    if (!s.tracedLine.corners.empty())
        return paintPolygon(s);
    QPen dashes = pen(s.colours.border, s.u);
    dashes.setDashPattern({5, 4});
    const auto& [min, max] = s.tracedLine.window;
    for (const Edge edge : {Edge::Left, Edge::Right, Edge::Bottom, Edge::Top})
        if (const auto line = edgeLine(edge, s.tracedLine, s.frame)) {
            s.painter.setPen(dashes);
            s.painter.drawLine(*line);
        }
    const QPen outline = pen(s.colours.window, 2 * s.u, Qt::SquareCap);
    for (const clipping::Segment& side : {clipping::Segment{{min.x, min.y}, {max.x, min.y}},
                                          {{max.x, min.y}, {max.x, max.y}},
                                          {{max.x, max.y}, {min.x, max.y}},
                                          {{min.x, max.y}, {min.x, min.y}}})
        strike(s, side, outline);
    if (min == max && s.frame.shows(min)) {
        s.painter.setPen(Qt::NoPen);
        s.painter.setBrush(s.colours.window);
        s.painter.drawEllipse(s.frame.at(min), 3 * s.u, 3 * s.u);
    }
}

void paintHighlightedEdge(const Picture& s)
{
    if (s.scene.polygonEdge)
        if (const auto line =
                polygonEdgeLine(s.scene.polygonEdge, s.tracedLine.corners, s.frame.seen))
            strike(s, *line, pen(s.colours.highlight, 2.5 * s.u));
    if (s.scene.edge == Edge::NoEdge || s.scene.edge > Edge::Top)
        return;
    if (const auto line = edgeLine(s.scene.edge, s.tracedLine, s.frame)) {
        s.painter.setPen(pen(s.colours.highlight, 2.5 * s.u));
        s.painter.drawLine(*line);
    }
}

/// Two short strokes across the middle of a rejected line.
void crossOut(const Picture& s)
{
    const auto part = s.frame.part(s.tracedLine.line);
    if (!part)
        return;
    const QPointF middle = part->center();
    const double r = 7 * s.u;
    s.painter.setPen(pen(s.colours.muted, 2.5 * s.u, Qt::RoundCap));
    s.painter.drawLine(middle - QPointF(r, r), middle + QPointF(r, r));
    s.painter.drawLine(middle - QPointF(r, -r), middle + QPointF(r, -r));
}

void paintLine(const Picture& s)
{
    const QPen gone = dashed(s.colours.muted, 1.75 * s.u);
    if (s.scene.state == StepScene::State::Rejected) {
        strike(s, s.tracedLine.line, gone);
        crossOut(s);
        return;
    }
    for (const auto& piece : s.scene.discarded)
        strike(s, piece, gone);
    for (const auto& piece : s.scene.discardedNow)
        strike(s, piece, dashed(s.colours.highlight, 2 * s.u));
    const bool accepted = s.scene.state == StepScene::State::Accepted;
    const auto& left = s.scene.left;
    strike(s, left, pen(s.colours.text, (accepted ? 4.5 : 3.5) * s.u));
    if (left.a == left.b && s.frame.shows(left.a)) {
        s.painter.setPen(Qt::NoPen);
        s.painter.setBrush(s.colours.text);
        s.painter.drawEllipse(s.frame.at(left.a), 3 * s.u, 3 * s.u);
    }
}

QColor colourOf(FigureMark::Tone tone, const FigureColours& colours)
{
    return tone == FigureMark::Tone::Highlighted ? colours.highlight
           : tone == FigureMark::Tone::Muted     ? colours.muted
                                                 : colours.text;
}

QPolygonF diamond(const QPointF& at, double r)
{
    return QPolygonF{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r),
                     at + QPointF(-r, 0)};
}

/// An arrow head at the picture's border that points to the end.
QPolygonF arrowHead(const FigureMark& mark, double r)
{
    const QLineF way = QLineF::fromPolar(r, mark.angle);
    const QPointF ahead(way.dx(), way.dy()), aside(-way.dy(), way.dx());
    return QPolygonF{mark.place + ahead, mark.place - ahead * 0.6 + aside * 0.75,
                     mark.place - ahead * 0.6 - aside * 0.75};
}

void paintMark(const Picture& s, const FigureMark& mark)
{
    using Shape = FigureMark::Shape;
    const QColor colour = colourOf(mark.tone, s.colours);
    const double r = radiusOf(mark, s.frame);
    const bool hollow = mark.shape == Shape::End || mark.shape == Shape::Candidate;
    s.painter.setPen(hollow ? pen(colour, 2 * s.u) : pen(s.colours.paper, 1.5 * s.u));
    s.painter.setBrush(hollow ? s.colours.paper : colour);
    if (mark.shape == Shape::End)
        s.painter.drawEllipse(mark.place, r, r);
    else
        s.painter.drawPolygon(mark.shape == Shape::FarEnd ? arrowHead(mark, r)
                                                          : diamond(mark.place, r));
}

QColor headColour(FigureLabel::Tone tone, const FigureColours& colours)
{
    const std::array row{colours.text, colours.onHighlight, colours.window, colours.muted,
                         colours.highlight};
    return row[std::size_t(tone)];
}

void paintLeader(const Picture& s, const FigureLabel& label)
{
    if (!label.leader)
        return;
    const QPointF& mark = *label.leader;
    const QPointF from(std::clamp(mark.x(), label.box.left(), label.box.right()),
                       std::clamp(mark.y(), label.box.top(), label.box.bottom()));
    s.painter.setPen(pen(s.colours.muted, 0.75 * s.u));
    s.painter.drawLine(from, mark);
}

void paintLabel(const Picture& s, const FigureLabel& label)
{
    const bool highlight = label.tone == FigureLabel::Tone::Highlighted;
    QColor ground = highlight ? s.colours.highlight : s.colours.paper;
    if (!highlight)
        ground.setAlphaF(0.82F);
    s.painter.setPen(Qt::NoPen);
    s.painter.setBrush(ground);
    s.painter.drawRoundedRect(label.box, 2 * s.u, 2 * s.u);
    const QRectF text = label.box.marginsRemoved(paddingOf(s.frame, label.tone));
    const QFont head = headFont(s.frame, label.tone), detail = detailFont(s.frame);
    s.painter.setFont(head);
    s.painter.setPen(headColour(label.tone, s.colours));
    s.painter.drawText(text.topLeft() + QPointF(0, QFontMetricsF(head).ascent()), label.head);
    if (label.detail.isEmpty())
        return;
    s.painter.setFont(detail);
    s.painter.setPen(highlight ? s.colours.onHighlight : s.colours.muted);
    const double down = QFontMetricsF(head).height() + QFontMetricsF(detail).ascent();
    s.painter.drawText(text.topLeft() + QPointF(0, down), label.detail);
}

} // namespace

void paintStep(QPainter& painter, const TraceStep& at, const FigureFrame& frame,
               const FigureColours& colours)
{
    const auto& [tracedLine, narration, step] = at;
    const StepScene scene = stepScene(tracedLine, narration, step);
    const Picture picture{painter, tracedLine, scene, frame, colours, frame.unit()};
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(frame.picture(), colours.paper);
    if (scene.edge != Edge::NoEdge && scene.edge <= Edge::Top)
        hatch(picture, beyond(picture, scene.edge));
    if (scene.polygonEdge)
        hatchBeyondSide(picture, scene.polygonEdge);
    paintWindow(picture);
    paintHighlightedEdge(picture);
    paintLine(picture);
    const auto labels = figureLabels(tracedLine, narration, scene, frame);
    for (const FigureLabel& label : labels)
        paintLeader(picture, label);
    for (const FigureMark& mark : figureMarks(tracedLine, scene, frame))
        paintMark(picture, mark);
    for (const FigureLabel& label : labels)
        paintLabel(picture, label);
    painter.restore();
}

} // namespace app
