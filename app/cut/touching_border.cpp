// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"
#include "app/cut/true_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

// Between a curve and its chord, a polygon does not tell whether something meets the curve: not
// where a line or another curve touches it, or crosses it twice at a very small angle. The border
// gets a corner where each of two curves is nearest to the other one. Between such corners they
// meet as often as their chords.

namespace app {
namespace {

/// Whether two curves, each so near to its chord, may have the same direction somewhere. A curve
/// turns from its chord by four times that over its length.
bool mayBeParallel(const Point& chord, const Point& other, double near)
{
    const double a = glm::length(chord), b = glm::length(other);
    constexpr double turn = 6;
    return std::abs(cross(chord, other)) <= turn * near * (a + b);
}

/// Whether a line passes a box, which is on one side of it, at least so far from it.
bool passesBy(const clipping::Segment& line, const clipping::Window& box, double away)
{
    const Point along = line.b - line.a, half = (box.max - box.min) * 0.5;
    const double reach = std::abs(along.x) * half.y + std::abs(along.y) * half.x;
    return std::abs(cross(along, box.min + half - line.a)) > reach + away * glm::length(along);
}

} // namespace

/// The number of the edge with a parameter of a source.
std::uint32_t CurvedBorder::numberOf(std::uint32_t source, double t) const
{
    auto [low, high] = edgesOf_[source];
    while (high - low > 1) {
        const std::uint32_t middle = low + (high - low) / 2;
        (edgeAt(edges_[middle]).t0 <= t ? low : high) = middle;
    }
    return low;
}

void CurvedBorder::addTouches(const clipping::Segment& line, Cuts& cuts) const
{
    const Point along = line.b - line.a;
    const double length = glm::dot(along, along), near = touchesNear();
    if (!(length > 0))
        return;
    curves_.meeting(around(line, near), 0, [&](std::uint32_t source) {
        const TrueCurve& curve = sources_[source];
        if (edgesOf_[source].second == 0 || passesBy(line, curve.box(), near))
            return;
        for (const double t : curve.parallelTo(along)) {
            const Point p = curve.at(t);
            const double way = glm::dot(p - line.a, along), away = cross(along, p - line.a);
            if (way >= 0 && way <= length && away * away <= near * near * length)
                cuts.on[numberOf(source, t)].push_back({p, Ending::Line});
        }
    });
}

/// One of the curve's chords beside an edge.
void CurvedBorder::addTouches(const TrueCurve& curve, const CurvePoint& from, const CurvePoint& to,
                              std::uint32_t number, Cuts& cuts) const
{
    const Place& place = edges_[number];
    const Edge& edge = edgeAt(place);
    const Point &begin = edge.from, &end = endOf(place);
    const auto isNear = [&](const Point& a, const Point& b, const Point& p) {
        return placeOn(a, b, p).distance <= touchesNear();
    };
    // Curves that are parallel nowhere meet once, if their chords do; there or beside it. Where a
    // curve ends, it may end between the edge and its curve.
    const bool isEnd = from.t == 0 || to.t == 1;
    if (!edge.isCurved() || isOf(edge, curve) || areSame(curve.ellipse(), sourceOf(edge).ellipse())
        || !(isEnd || mayBeParallel(to.point - from.point, end - begin, touchesNear()))
        || !(isNear(begin, end, from.point) || isNear(begin, end, to.point)
             || isNear(from.point, to.point, begin) || isNear(from.point, to.point, end)))
        return;
    const TrueCurve& border = sourceOf(edge);
    double low = curve.near(begin, from.t, to.t), high = curve.near(end, from.t, to.t);
    if (low == high) // the edge is before or behind the chord
        return;
    const Gap atLow = gapAt(curve, low, border, edge), atHigh = gapAt(curve, high, border, edge);
    const auto add = [&](const Gap& gap) {
        if (gap.distance <= touchesNear() && gap.u > edge.t0 && gap.u < edge.t1)
            cuts.on[number].push_back({border.at(gap.u), Ending::Line});
    };
    const double same = near_ / 1000;
    if (atLow.distance <= same && atHigh.distance <= same)
        return; // it runs along the border, or is the border
    if (low == from.t || low == to.t)
        add(atLow);
    if (high == from.t || high == to.t)
        add(atHigh);
    if ((atLow.turn < 0) == (atHigh.turn < 0))
        return;
    Gap nearest = atLow;
    constexpr int enough = 30; // the place need not be exact: the gap hardly changes there
    for (int i = 0; i < enough; ++i) {
        const double middle = (low + high) / 2;
        nearest = gapAt(curve, middle, border, edge);
        ((nearest.turn < 0) == (atLow.turn < 0) ? low : high) = middle;
    }
    add(nearest);
}

/// From a place on a curve to the nearest one on an edge's curve.
CurvedBorder::Gap CurvedBorder::gapAt(const TrueCurve& curve, double t, const TrueCurve& border,
                                      const Edge& edge)
{
    const Point p = curve.at(t);
    const double u = border.near(p, edge.t0, edge.t1);
    return {u, glm::distance(border.at(u), p), cross(curve.slope(t), border.slope(u))};
}

// Straight edges need no more corners, the curve does: where it is parallel to one, and at corners.
// Within a nanometre of an edge, a curve touches it, and is not cut there.
void CurvedBorder::addSidesBeside(const TrueCurve& curve, const Chord& chord, double tolerance,
                                  std::vector<CurvePoint>& ends) const
{
    const auto add = [&](double t, const Point& p, double distance) {
        if (t > chord.t0 && t < chord.t1 && distance <= tolerance && distance > near_ / 1000)
            ends.push_back({t, p});
    };
    sidesAt_.meeting(around(chord.segment, tolerance), 0, [&](std::uint32_t number) {
        const auto& [a, b] = sides_[number];
        for (const double t : curve.parallelTo(b - a)) {
            const Point p = curve.at(t);
            add(t, p, placeOn(a, b, p).distance);
        }
        if (placeOn(chord.segment.a, chord.segment.b, a).distance > tolerance)
            return;
        const double t = curve.near(a, chord.t0, chord.t1);
        add(t, curve.at(t), glm::distance(curve.at(t), a));
    });
}

void CurvedBorder::addTouchesOf(const ObjectView& object, double tolerance, Cuts& cuts) const
{
    if (const auto line = object.singleLine())
        return addTouches(*line, cuts);
    if (!isBeside(object.path()))
        return;
    for (const Subpath& path : object.path().subpaths()) {
        std::vector<Chord> chords;
        flattenTruly(path, tolerance, chords);
        for (std::size_t i = 0, end = 0; i < chords.size(); i = end) {
            const std::size_t segment = chords[i].pathSegment;
            end = i + 1;
            if (!isCurve(path, segment)) {
                addTouches(chords[i].segment, cuts);
                continue;
            }
            while (end < chords.size() && chords[end].pathSegment == segment)
                ++end;
            if (!isFine())
                continue;
            const TrueCurve curve = curveAt(path, segment);
            const Beside near = beside(curve, std::span(chords).subspan(i, end - i), tolerance);
            CurvePoint last{0, chords[i].segment.a};
            for (const CurvePoint& next : near.ends) {
                if (!near.edges.empty())
                    index_.meeting(
                        around({last.point, next.point}, touchesNear()), 0,
                        [&](std::uint32_t edge) { addTouches(curve, last, next, edge, cuts); });
                last = next;
            }
        }
    }
}

std::optional<CurvedBorder> CurvedBorder::dividedFor(std::span<const clipping::Segment> lines) const
{
    Cuts cuts;
    if (!isEmpty())
        for (const clipping::Segment& line : lines)
            addTouches(line, cuts);
    if (cuts.on.empty())
        return std::nullopt;
    CurvedBorder divided = *this;
    divided.divide(cuts);
    return divided;
}

} // namespace app
