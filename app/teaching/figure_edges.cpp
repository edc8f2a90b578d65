// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/figure_edges.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using clipping::Edge;
using At = EdgePlace::At;

constexpr std::array edges{Edge::Left, Edge::Right, Edge::Bottom, Edge::Top};

/// The two edges across an axis; `axis` 0: left and right.
std::array<Edge, 2> edgesAcross(glm::length_t axis)
{
    return axis == 0 ? std::array{Edge::Left, Edge::Right} : std::array{Edge::Bottom, Edge::Top};
}

std::array<Edge, 2> edgesBeside(Edge edge) { return edgesAcross(1 - clipping::axisOf(edge)); }

double onAxis(const QPointF& point, glm::length_t axis)
{
    return axis == 0 ? point.x() : point.y();
}

QPointF pointOn(glm::length_t axis, double along, double across)
{
    return axis == 0 ? QPointF(along, across) : QPointF(across, along);
}

/// How far a line's nearest end is from a level; empty if the level is between its ends.
std::optional<double> distanceTo(double level, const clipping::Segment& line, glm::length_t axis)
{
    const auto [low, high] = std::minmax(line.a[axis], line.b[axis]);
    if (low < level && level < high)
        return std::nullopt;
    const double far = level >= high ? level - high : low - level;
    return std::isfinite(far) ? std::optional(far) : std::nullopt;
}

} // namespace

FigureEdges::FigureEdges(const TracedLine& tracedLine, const FigureFrame& frame)
    : picture_(frame.picture()), y_(frame.y), unit_(frame.unit())
{
    placePair(tracedLine, frame, 0);
    placePair(tracedLine, frame, 1);
}

/// A distance from the border: `most` strokes' units, but of a small picture only a share.
double FigureEdges::inset(glm::length_t axis, double most, double share) const
{
    return std::min(most * unit_, share * onAxis({picture_.width(), picture_.height()}, axis));
}

/// Places the two edges across an axis.
void FigureEdges::placePair(const TracedLine& tracedLine, const FigureFrame& frame,
                            glm::length_t axis)
{
    const double length = onAxis({picture_.width(), picture_.height()}, axis);
    const double rim = inset(axis, 48, 0.1), gap = inset(axis, 24, 0.05);
    const auto part = frame.part(tracedLine.line);
    const auto isClear = [&](double place, double inward) { // of the line
        return !part
               || std::min(inward * onAxis(part->p1(), axis), inward * onAxis(part->p2(), axis))
                      > inward * place + gap / 2;
    };
    for (const Edge edge : edgesAcross(axis)) {
        const double level = clipping::levelOf(edge, tracedLine.window);
        EdgePlace& place = places_[std::size_t(edge)];
        place.place = onAxis(frame.at({level, level}), axis);
        if (!std::isfinite(level))
            continue;
        if (level >= frame.seen.min[axis] && level <= frame.seen.max[axis]) {
            place.at = At::Scale;
            continue;
        }
        const double inward = place.place < length / 2 ? 1 : -1;
        const double atRim = inward > 0 ? rim : length - rim;
        if (isClear(atRim, inward))
            place = {At::Rim, atRim, inward, distanceTo(level, tracedLine.line, axis)};
    }
    // Of two edges on the same side only the nearer one is drawn, and the window is never inverted.
    const auto [first, second] = edgesAcross(axis);
    const auto mustGo = [&](Edge edge, Edge other) {
        const EdgePlace &its = (*this)[edge], &others = (*this)[other];
        if (its.at != At::Rim || others.at == At::Away)
            return false;
        if (others.at == At::Scale)
            return its.inward * (others.place - its.place) < gap;
        const double level = clipping::levelOf(edge, tracedLine.window),
                     othersLevel = clipping::levelOf(other, tracedLine.window);
        const bool isFarther =
            level < frame.seen.min[axis] ? level <= othersLevel : level >= othersLevel;
        return its.inward == others.inward && isFarther;
    };
    for (const auto& [edge, other] : {std::pair(first, second), std::pair(second, first)})
        if (mustGo(edge, other)) {
            EdgePlace& place = places_[std::size_t(edge)];
            place = {At::Away, place.inward > 0 ? -1e6 : 1e6};
        }
}

bool FigureEdges::areToScale() const
{
    return std::ranges::none_of(edges, [&](Edge edge) { return (*this)[edge].at == At::Rim; });
}

std::optional<QLineF> FigureEdges::line(Edge edge) const
{
    const EdgePlace& its = (*this)[edge];
    if (its.at == At::Away)
        return std::nullopt;
    const glm::length_t along = 1 - clipping::axisOf(edge);
    double from = 0, to = onAxis({picture_.width(), picture_.height()}, along);
    if (its.at == At::Rim)
        for (const Edge end : edgesBeside(edge))
            if (const EdgePlace& beside = (*this)[end]; beside.at == At::Rim)
                (beside.inward > 0 ? from : to) = beside.place;
    return QLineF(pointOn(along, from, its.place), pointOn(along, to, its.place));
}

std::optional<QLineF> FigureEdges::side(Edge edge) const
{
    const EdgePlace& its = (*this)[edge];
    if (its.at == At::Away)
        return std::nullopt;
    const glm::length_t along = 1 - clipping::axisOf(edge);
    const double length = onAxis({picture_.width(), picture_.height()}, along);
    const auto [one, other] = edgesBeside(edge);
    const auto [from, to] = std::minmax((*this)[one].place, (*this)[other].place);
    if (to < 0 || from > length)
        return std::nullopt;
    return QLineF(pointOn(along, std::max(from, 0.0), its.place),
                  pointOn(along, std::min(to, length), its.place));
}

QRectF FigureEdges::window() const
{
    return QRectF(QPointF((*this)[Edge::Left].place, (*this)[Edge::Bottom].place),
                  QPointF((*this)[Edge::Right].place, (*this)[Edge::Top].place))
        .normalized();
}

QRectF FigureEdges::beyond(Edge edge) const
{
    const double place = (*this)[edge].place;
    const bool isLower = edge == clipping::lowerEdge(clipping::axisOf(edge));
    QRectF part = picture_;
    if (clipping::axisOf(edge) == 0)
        isLower ? part.setRight(place) : part.setLeft(place);
    else if (isLower == (y_ == YAxis::Down))
        part.setBottom(place);
    else
        part.setTop(place);
    return part.isValid() ? part & picture_ : QRectF();
}

std::vector<FigureEdges::Break> FigureEdges::breaks() const
{
    std::vector<Break> marks;
    for (const Edge edge : edges)
        if ((*this)[edge].at != At::Away)
            addBreaks(marks, edge);
    return marks;
}

/// The breaks of an edge's line: before each end of it that is at the rim. If nothing of the line
/// is to scale, one in its middle is enough.
void FigureEdges::addBreaks(std::vector<Break>& marks, Edge edge) const
{
    const EdgePlace& its = (*this)[edge];
    const glm::length_t along = 1 - clipping::axisOf(edge);
    std::vector<double> places;
    for (const Edge end : edgesBeside(edge))
        if (const EdgePlace& beside = (*this)[end]; beside.at == At::Rim)
            places.push_back(beside.place
                             + beside.inward * inset(along, along == 0 ? 60 : 36, 0.07));
    if (its.at == At::Rim && places.size() == 2)
        places = {(places[0] + places[1]) / 2};
    for (const double place : places)
        marks.push_back({pointOn(along, place, its.place), along == 1});
}

QRectF FigureEdges::boxOf(const Break& mark) const
{
    const double wide = 14 * unit_, thick = 9 * unit_;
    const QPointF half = mark.acrossVertical ? QPointF(wide, thick) : QPointF(thick, wide);
    return {mark.place - half, mark.place + half};
}

} // namespace app
