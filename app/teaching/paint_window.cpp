// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/paint_window.h"

#include "app/overlays/half_plane.h"
#include "app/overlays/polygon_edges.h"
#include "app/teaching/figure_edges.h"

#include <QPainter>

#include <array>

namespace app {

namespace {

using clipping::Edge;
using Painting = FigurePainting;

constexpr std::array rectangleEdges{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

bool isOfRectangle(Edge edge) { return edge != Edge::NoEdge && edge <= Edge::Top; }

QPen outlinePen(const QColor& colour, double width, Qt::PenCapStyle cap = Qt::FlatCap)
{
    return {colour, width, Qt::SolidLine, cap, Qt::MiterJoin};
}

/// The part of the picture beyond the line of a polygon's side.
QPolygonF beyondSide(const Painting& s, std::size_t number)
{
    const auto [from, to] = polygonEdge(number, s.tracedLine.corners);
    const Point along = to - from;
    QPolygonF area;
    for (const Point& p : common(s.frame.seen, std::array{HalfPlane{from, {along.y, -along.x}}}))
        area << s.frame.at(p);
    return area;
}

void strikeEdge(const Painting& s, const clipping::Segment& line, const QPen& with)
{
    if (const auto part = s.frame.part(line)) {
        s.painter.setPen(with);
        s.painter.drawLine(*part);
    }
}

void paintPolygon(const Painting& s)
{
    const double u = s.frame.unit();
    const auto& corners = s.tracedLine.corners;
    for (std::size_t i = 1; i <= corners.size(); ++i)
        strikeEdge(s, polygonEdge(i, corners), outlinePen(s.colours.window, 2 * u, Qt::RoundCap));
    if (const auto line = s.scene.polygonEdge
                              ? polygonEdgeLine(s.scene.polygonEdge, corners, s.frame.seen)
                              : std::nullopt)
        strikeEdge(s, *line, outlinePen(s.colours.highlight, 2.5 * u));
}

void paintEdgeLines(const Painting& s, const FigureEdges& edges)
{
    QPen dashes = outlinePen(s.colours.border, s.frame.unit());
    dashes.setDashPattern({5, 4});
    s.painter.setPen(dashes);
    for (const Edge edge : rectangleEdges)
        if (const auto line = edges.line(edge))
            s.painter.drawLine(*line);
}

/// In a magnified window, the edges that are to scale are stronger.
void paintSides(const Painting& s, const FigureEdges& edges)
{
    const double u = s.frame.unit();
    for (const Edge edge : rectangleEdges)
        if (const auto side = edges.side(edge)) {
            const bool strong = !edges.areToScale() && edges[edge].at == EdgePlace::At::Scale;
            s.painter.setPen(outlinePen(s.colours.window, (strong ? 3 : 2) * u, Qt::SquareCap));
            s.painter.drawLine(*side);
        }
    const auto& [min, max] = s.tracedLine.window;
    if (min == max && s.frame.shows(min)) {
        s.painter.setPen(Qt::NoPen);
        s.painter.setBrush(s.colours.window);
        s.painter.drawEllipse(s.frame.at(min), 3 * u, 3 * u);
    }
}

/// A zigzag through a place, along an axis; `unit` wide as a stroke.
QPolygonF zigzag(const QPointF& place, bool horizontal, double unit)
{
    constexpr std::array<double, 5> along{-13, -6.5, 0, 6.5, 13}, across{2, -3, 2, -3, 2};
    QPolygonF points;
    for (std::size_t i = 0; i < along.size(); ++i)
        points << place
                      + unit
                            * (horizontal ? QPointF(along[i], across[i])
                                          : QPointF(across[i], along[i]));
    return points;
}

/// Two zigzags with paper between: a part of the line is left out.
void paintBreak(const Painting& s, const FigureEdges::Break& mark)
{
    const double u = s.frame.unit();
    const QPointF half = mark.acrossVertical ? QPointF(0, 5 * u) : QPointF(5 * u, 0);
    const QPolygonF one = zigzag(mark.place - half, mark.acrossVertical, u),
                    other = zigzag(mark.place + half, mark.acrossVertical, u);
    QPolygonF between = one;
    for (auto point = other.crbegin(); point != other.crend(); ++point)
        between << *point;
    s.painter.setPen(Qt::NoPen);
    s.painter.setBrush(s.colours.paper);
    s.painter.drawPolygon(between);
    s.painter.setPen(outlinePen(s.colours.muted, 1.3 * u, Qt::RoundCap));
    s.painter.drawPolyline(one);
    s.painter.drawPolyline(other);
}

} // namespace

void paintGround(const FigurePainting& s)
{
    s.painter.setPen(Qt::NoPen);
    s.painter.setBrush(s.colours.beyond);
    if (s.scene.polygonEdge)
        s.painter.drawPolygon(beyondSide(s, s.scene.polygonEdge));
    else if (isOfRectangle(s.scene.edge))
        s.painter.drawRect(FigureEdges(s.tracedLine, s.frame).beyond(s.scene.edge));
}

void paintWindow(const FigurePainting& s)
{
    if (!s.tracedLine.corners.empty())
        return paintPolygon(s);
    const FigureEdges edges(s.tracedLine, s.frame);
    paintEdgeLines(s, edges);
    paintSides(s, edges);
    if (isOfRectangle(s.scene.edge))
        if (const auto line = edges.line(s.scene.edge)) {
            s.painter.setPen(outlinePen(s.colours.highlight, 2.5 * s.frame.unit()));
            s.painter.drawLine(*line);
        }
    for (const FigureEdges::Break& mark : edges.breaks())
        paintBreak(s, mark);
}

} // namespace app
