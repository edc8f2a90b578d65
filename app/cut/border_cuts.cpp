// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// The polygon only tells which edge is met: a cut lies where the true curves meet.

namespace app {

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
    const bool isBeyond =
        glm::dot(met - line.a, line.b - line.a) < 0 || glm::dot(met - line.b, line.a - line.b) < 0;
    return isBeyond ? std::nullopt : std::optional(BorderMeeting{met, 0, part.curve, low});
}

std::optional<BorderMeeting> CurvedBorder::meeting(const TrueCurve& curve, const Chord& chord,
                                                   const Point& cut) const
{
    const auto place = edgeThrough(cut);
    if (!place)
        return std::nullopt;
    const CurvePart part = partOf(*place);
    const double width = chord.t1 - chord.t0, reach = part.to - part.from;
    double t = chord.t0 + width * placeOn(chord.segment.a, chord.segment.b, cut).share;
    double u = part.parameterAt(placeOn(edgeAt(*place).from, endOf(*place), cut).share);
    constexpr int most = 20;
    for (int i = 0; i < most; ++i) {
        const Point gap = part.curve->at(u) - curve.at(t);
        const Point along = curve.slope(t), across = part.curve->slope(u);
        const double turn = cross(along, across);
        const double byT = cross(gap, across) / turn, byU = cross(gap, along) / turn;
        if (!std::isfinite(byT) || !std::isfinite(byU))
            return std::nullopt;
        t += byT;
        u += byU;
        // It may be on a neighbouring part of the same curves.
        if (t < std::max(0.0, chord.t0 - width) || t > std::min(1.0, chord.t1 + width)
            || std::abs(u - part.from - reach / 2) > 1.5 * std::abs(reach))
            return std::nullopt;
        if (std::abs(byT) <= 1e-15 && std::abs(byU) <= 1e-15)
            break;
    }
    const Point met = curve.at(t);
    return glm::distance(met, part.curve->at(u)) <= near_ / 1e4
               ? std::optional(BorderMeeting{met, t, part.curve, u})
               : std::nullopt;
}

} // namespace app
