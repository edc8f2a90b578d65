// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"
#include "clipping/exact/turn.h"
#include "clipping/polygon/prepared.h"

#include <algorithm>

namespace clipping {

/// The visible piece of a segment, and the numbers (geometry.h) of the edges that cut it, 0 for
/// none.
template <class T>
struct PolygonPiece {
    BasicSegment<T> segment;
    std::uint32_t numberOfA = 0, numberOfB = 0;
};

/// The intersection of the bounding boxes of two segments.
template <class T>
BasicWindow<T> commonBox(const BasicSegment<T>& s, const BasicSegment<T>& t)
{
    const auto low = [](T p, T q, T r, T u) { return std::max(std::min(p, q), std::min(r, u)); };
    const auto high = [](T p, T q, T r, T u) { return std::min(std::max(p, q), std::max(r, u)); };
    return {{low(s.a.x, s.b.x, t.a.x, t.b.x), low(s.a.y, s.b.y, t.a.y, t.b.y)},
            {high(s.a.x, s.b.x, t.a.x, t.b.x), high(s.a.y, s.b.y, t.a.y, t.b.y)}};
}

/// The point where `edge` crosses s; the two must cross. The products are the cross products of the
/// edge's ends with the line of s. The point is computed from the nearer end, so that a contact
/// with a corner is that corner (decided by its sign where the products underflow). It is clamped
/// to the common box of both, which keeps it near both even where they are almost parallel.
template <class T>
glm::vec<2, T> meetOnEdge(const BasicSegment<T>& edge, const Cross<T>& ofA, const Cross<T>& ofB,
                          const BasicSegment<T>& s)
{
    const bool nearerB = magnitude(ofB.value) < magnitude(ofA.value);
    const bool fromA = ofA.sign == 0 || (ofB.sign != 0 && !nearerB);
    const auto &near = fromA ? edge.a : edge.b, &far = fromA ? edge.b : edge.a;
    const T share = fromA ? shareBefore(ofA, ofB) : shareBefore(ofB, ofA);
    const glm::vec<2, T> met{near.x + share * (far.x - near.x), near.y + share * (far.y - near.y)};
    return clamped(met, commonBox(edge, s));
}

/// The same point, or the one of a method that has its own function for it.
template <class Method, class T>
glm::vec<2, T> meetFlat(const BasicSegment<T>& edge, const Cross<T>& ofA, const Cross<T>& ofB,
                        const BasicSegment<T>& s)
{
    if constexpr (requires { Method::pointOn(edge, ofA.sign, ofB.sign, s); })
        return Method::pointOn(edge, ofA.sign, ofB.sign, s);
    else
        return meetOnEdge(edge, ofA, ofB, s);
}

/// Clips at a polygon without area, for which normals and sides are undefined: intersects two
/// segments. All decisions are exact, and so is the common part of collinear segments. `rejected`
/// is the label of the method's rejection of a line that misses the polygon.
template <class Method, class T, class Step>
std::optional<PolygonPiece<T>> clipFlat(const BasicSegment<T>& s, const PolygonIn<T>& polygon,
                                        Step&& step)
{
    const std::size_t last = polygon.size() - 1;
    const BasicSegment<T> edge{polygon.corner(0), polygon.corner(last)};
    const auto edgeA = leftOf(s.a, s.b, edge.a), edgeB = leftOf(s.a, s.b, edge.b);
    const auto a = leftOf(edge.a, edge.b, s.a), b = leftOf(edge.a, edge.b, s.b);
    PolygonPiece<T> piece{s};
    if (edgeA.sign * edgeB.sign > 0 || a.sign * b.sign > 0)
        return step.reject(Method::rejected);
    if (edgeA.sign == 0 && edgeB.sign == 0 && a.sign == 0 && b.sign == 0) { // all collinear
        const auto before = [](const glm::vec<2, T>& p, const glm::vec<2, T>& q) {
            return p.x < q.x || (p.x == q.x && p.y < q.y);
        };
        const bool along = !before(s.b, s.a), edgeAlong = !before(edge.b, edge.a);
        const bool swapped = along != edgeAlong;
        const auto &in = swapped ? edge.b : edge.a, &out = swapped ? edge.a : edge.b;
        const auto later = [&](const auto& p, const auto& q) {
            return along ? before(q, p) : before(p, q);
        };
        if (later(in, s.a))
            piece.segment.a = in, piece.numberOfA = polygon.number(swapped ? last : 0);
        if (later(s.b, out))
            piece.segment.b = out, piece.numberOfB = polygon.number(swapped ? 0 : last);
        if (later(piece.segment.a, piece.segment.b))
            return step.reject(Method::rejected);
    } else {
        const auto met = a.sign == 0   ? s.a
                         : b.sign == 0 ? s.b
                                       : meetFlat<Method>(edge, edgeA, edgeB, s);
        piece = {
            {met, met}, a.sign == 0 ? 0 : polygon.number(0), b.sign == 0 ? 0 : polygon.number(0)};
    }
    step.accept("accept", piece.segment);
    return piece;
}

} // namespace clipping
