// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"
#include "app/document/path.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// The polygon only tells which edge is met: a cut lies where the true curves meet.

namespace app {
namespace {

/// By bisection, if the ends of the chord are on both sides of the curve beside the part.
std::optional<CurvePlaces> meetingBetween(const TrueCurve& curve, const Chord& chord,
                                          const CurvePart& part)
{
    const auto [first, last] = std::minmax(part.from, part.to);
    const double low = std::max(0.0, first - (last - first)),
                 high = std::min(1.0, last + (last - first));
    const auto besideOf = [&](double t) { return part.curve->near(curve.at(t), low, high); };
    const auto isLeft = [&](double t) {
        const double u = besideOf(t);
        return cross(part.curve->slope(u), curve.at(t) - part.curve->at(u)) > 0;
    };
    double from = chord.t0, to = chord.t1;
    const bool atFrom = isLeft(from);
    if (atFrom == isLeft(to))
        return std::nullopt;
    for (double middle = (from + to) / 2; middle > from && middle < to; middle = (from + to) / 2)
        (isLeft(middle) == atFrom ? from : to) = middle;
    return CurvePlaces{from, besideOf(from)};
}

} // namespace

std::optional<CurvedBorder::Place> CurvedBorder::edgeThrough(const Point& cut) const
{
    std::optional<Place> nearest;
    double least = near_ / 1000; // a nanometre on paper
    index_.meeting({cut, cut}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        const double distance = placeOn(edgeAt(place).from, endOf(place), cut).distance;
        if (edgeAt(place).isCurved() && distance <= least) {
            least = distance;
            nearest = place;
        }
    });
    return nearest;
}

CurvePart CurvedBorder::partOf(const Place& place) const
{
    const Edge& edge = edgeAt(place);
    return {&sourceOf(edge), edge.t0, edge.t1};
}

/// Where the curve of an edge meets straight edges, and curves of other windows with a higher
/// number.
void CurvedBorder::addCrossings(std::uint32_t number, Cuts& cuts) const
{
    const Place& place = edges_[number];
    const Edge& edge = edgeAt(place);
    if (!edge.isCurved())
        return;
    const TrueCurve& curve = sourceOf(edge);
    const Chord chord{{edge.from, endOf(place)}, 0, edge.t0, edge.t1};
    const clipping::Window box = around(chord.segment, touchesNear());
    const auto isBetween = [&](const clipping::Segment& side, const Point& p) {
        return placeOn(side.a, side.b, p).distance <= near_ / 1000;
    };
    sidesAt_.meeting(box, 0, [&](std::uint32_t side) {
        if (const auto met = crossing(curve, chord, sides_[side]);
            met && isBetween(sides_[side], met->point))
            cuts.on[number].push_back({met->point, Ending::Line});
    });
    index_.meeting(box, number + 1, [&](std::uint32_t other) {
        const Place& there = edges_[other];
        const Edge& across = edgeAt(there);
        if (!across.isCurved() || rings_[there.ring].window == rings_[place.ring].window
            || areSame(curve.ellipse(), sourceOf(across).ellipse()) || isOf(across, curve))
            return;
        const clipping::Segment line{across.from, endOf(there)};
        const auto sideOf = [](const clipping::Segment& of, const Point& p) {
            return cross(of.b - of.a, p - of.a) > 0;
        };
        if (sideOf(line, chord.segment.a) == sideOf(line, chord.segment.b)
            || sideOf(chord.segment, line.a) == sideOf(chord.segment, line.b))
            return;
        const auto met = meetingNear(curve, chord, partOf(there),
                                     {(edge.t0 + edge.t1) / 2, (across.t0 + across.t1) / 2});
        if (!met || met->t <= 0 || met->t >= 1 || met->u <= 0 || met->u >= 1)
            return;
        const Point p = curve.at(met->t);
        cuts.on[numberOf(edge.source, met->t)].push_back({p, Ending::Line});
        cuts.on[numberOf(across.source, met->u)].push_back({p, Ending::Line});
    });
}

/// So that a corner of what several windows leave is where their true borders meet.
void CurvedBorder::divideWhereWindowsCross()
{
    Cuts cuts;
    for (std::uint32_t edge = 0; edge < edges_.size(); ++edge)
        addCrossings(edge, cuts);
    divide(cuts);
}

bool CurvedBorder::isNothing(const Subpath& piece) const
{
    bool is = !isEmpty();
    forEachPoint(piece, [&](const Point& p) { is = is && glm::distance(p, piece.start) <= near_; });
    const bool isPoint = piece.segments.empty() || piece.segments.back().to == piece.start;
    return is && !isPoint; // single points are kept on purpose
}

std::optional<CurvePart> CurvedBorder::partAlong(const clipping::Segment& edge) const
{
    std::optional<CurvePart> found;
    index_.meeting({edge.a, edge.a}, 0, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        if (!edgeAt(place).isCurved())
            return;
        const Point &from = edgeAt(place).from, &to = endOf(place);
        const auto [curve, t0, t1] = partOf(place);
        if (from == edge.a && to == edge.b)
            found = {curve, t0, t1};
        else if (from == edge.b && to == edge.a)
            found = {curve, t1, t0};
    });
    return found;
}

std::optional<BorderMeeting> CurvedBorder::meeting(const clipping::Segment& line,
                                                   const Point& cut) const
{
    const auto place = edgeThrough(cut);
    if (!place)
        return std::nullopt;
    const auto isLeft = [&](const Point& p) { return cross(line.b - line.a, p - line.a) > 0; };
    const Point &from = edgeAt(*place).from, &to = endOf(*place);
    if ((line.a == from && line.b == to) || (line.a == to && line.b == from))
        return std::nullopt; // along it: another window cuts there
    const CurvePart part = partOf(*place);
    double low = part.from, high = part.to;
    const bool atLow = isLeft(part.curve->at(low));
    if (atLow == isLeft(part.curve->at(high)))
        return std::nullopt;
    for (double middle = (low + high) / 2; middle != low && middle != high;
         middle = (low + high) / 2)
        (isLeft(part.curve->at(middle)) == atLow ? low : high) = middle;
    Point met = part.curve->at(low);
    for (const int axis : {0, 1})
        if (line.a[axis] == line.b[axis])
            met[axis] = line.a[axis];
    if (glm::dot(met - line.a, line.b - line.a) < 0) // it begins between the curve and its chord
        met = line.a;
    else if (glm::dot(met - line.b, line.a - line.b) < 0)
        met = line.b;
    return BorderMeeting{met, 0, part.curve, low};
}

std::optional<BorderMeeting> CurvedBorder::meeting(const TrueCurve& curve, const Chord& chord,
                                                   const Point& cut) const
{
    const auto place = edgeThrough(cut);
    if (!place)
        return std::nullopt;
    const CurvePart part = partOf(*place);
    const double share = placeOn(edgeAt(*place).from, endOf(*place), cut).share;
    const CurvePlaces near{
        chord.t0 + (chord.t1 - chord.t0) * placeOn(chord.segment.a, chord.segment.b, cut).share,
        part.parameterAt(share)};
    auto met = meetingNear(curve, chord, part, near);
    const bool isInside = met && met->t >= chord.t0 && met->t <= chord.t1;
    if (!isInside)
        if (const auto between = meetingBetween(curve, chord, part))
            met = between;
    if (!met)
        return std::nullopt;
    const Point p = curve.at(met->t);
    return glm::distance(p, part.curve->at(met->u)) <= near_ / 1e4
               ? std::optional(BorderMeeting{p, met->t, part.curve, met->u})
               : std::nullopt;
}

} // namespace app
