// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/crossing.h"

// The algorithm of algorithms/exact.cpp, on a vector of segments at once.

namespace clipping {
namespace {

/// Segments mirrored so that they run right and up. Then the near edges, where they can enter, are
/// left and bottom, and the far edges, where they can leave, are right and top.
template <class V>
struct Mirrored {
    V signX, signY;   ///< sign bits of the mirroring
    V ax, ay, bx, by; ///< mirrored coordinates
    V nearX, nearY, farX, farY;
    V entryX, entryY, exitX, exitY; ///< the edges' original coordinates
};
template <class V>
CLIPPING_INLINE Mirrored<V> mirrored(const Ends<V>& s, const VectorWindow<V>& w)
{
    const V signX = signOf(s.bx - s.ax), signY = signOf(s.by - s.ay);
    const V entryX = select(signX, w.maxX, w.minX), exitX = select(signX, w.minX, w.maxX);
    const V entryY = select(signY, w.maxY, w.minY), exitY = select(signY, w.minY, w.maxY);
    return {signX,        signY,          s.ax ^ signX,   s.ay ^ signY,  s.bx ^ signX,
            s.by ^ signY, entryX ^ signX, entryY ^ signY, exitX ^ signX, exitY ^ signY,
            entryX,       entryY,         exitX,          exitY};
}

/// The order in which lines pass the edges, by the part of the segment before each edge. These
/// parts are between 0 and 1 wherever they matter. Where a difference is 0, a quotient may be NaN;
/// then max and min return their second argument.
template <class V>
struct Passing {
    typename V::Mask visible, gone; ///< neither: undecided, too close to tell
    typename V::Mask enterByX, leaveByX;
    typename V::Mask entryUnsure, exitUnsure;
};
template <class V>
CLIPPING_INLINE Passing<V> passing(const Mirrored<V>& m, V inverseX, V inverseY)
{
    const V zero = V::of(0), one = V::of(1), bound = V::of(parameterBound);
    const V enterX = max((m.nearX - m.ax) * inverseX, zero);
    const V enterY = max((m.nearY - m.ay) * inverseY, zero);
    const V leaveX = min((m.farX - m.ax) * inverseX, one);
    const V leaveY = min((m.farY - m.ay) * inverseY, one);
    const V shown = min(leaveX, leaveY) - max(enterX, enterY);
    const V entryOrder = enterX - enterY, exitOrder = leaveY - leaveX;
    return {shown > bound, shown<V::of(-parameterBound), entryOrder> zero, exitOrder > zero,
            ~(abs(entryOrder) > bound), ~(abs(exitOrder) > bound)};
}

/// The bits of `cut` for an end on an edge of an axis, shifted into place.
template <class V>
CLIPPING_INLINE V edgeBits(V sign, Edge positive, Edge negative, int shift)
{
    const auto edge = [shift](Edge e) { return V::ofBits(std::uint64_t(e) << (32 + shift)); };
    return select(sign, edge(negative), edge(positive));
}

/// A coordinate of a new end: the edge's, or the computed one with the mirroring undone.
template <class V>
CLIPPING_INLINE V placed(typename V::Mask onEdge, V edge, V value, V sign)
{
    return select(onEdge, edge, (value ^ sign) + V::of(0)); // never -0
}

template <Care care, class V>
CLIPPING_INLINE Clip<V> clipLanes(const Ends<V>& original, const VectorWindow<V>& w)
{
    const Mirrored<V> m = mirrored(original, w);
    const auto newA = (m.ax < m.nearX) | (m.ay < m.nearY);
    const auto newB = (m.bx > m.farX) | (m.by > m.farY);
    const V zero = V::of(0), dx = m.bx - m.ax, dy = m.by - m.ay;
    const auto odd = irregular(dx) | irregular(dy);
    const auto touched = newA | newB | odd;
    if (!any(touched))
        return {original, zero, ~touched, touched};

    const V inverseX = V::of(1) / dx, inverseY = V::of(1) / dy;
    const Passing<V> order = passing(m, inverseX, inverseY);
    const Extent<V> extent{{dx, lowOfDifference(m.bx, m.ax, dx)},
                           {dy, lowOfDifference(m.by, m.ay, dy)},
                           inverseX,
                           inverseY};
    const auto byX = order.enterByX, outByX = order.leaveByX;
    const auto a = crossing<care>(extent, byX, m.ax, m.ay, m.nearX, m.nearY);
    const auto b = crossing<care>(extent, outByX, m.ax, m.ay, m.farX, m.farY);
    const Ends<V> piece{select(newA, placed(byX, m.entryX, a.value, m.signX), original.ax),
                        select(newA, placed(~byX, m.entryY, a.value, m.signY), original.ay),
                        select(newB, placed(outByX, m.exitX, b.value, m.signX), original.bx),
                        select(newB, placed(~outByX, m.exitY, b.value, m.signY), original.by)};
    const V cutA = select(byX, edgeBits(m.signX, Edge::Left, Edge::Right, 0),
                          edgeBits(m.signY, Edge::Bottom, Edge::Top, 0));
    const V cutB = select(outByX, edgeBits(m.signX, Edge::Right, Edge::Left, 8),
                          edgeBits(m.signY, Edge::Top, Edge::Bottom, 8));
    const auto open =
        (newA & (order.entryUnsure | ~a.settled)) | (newB & (order.exitUnsure | ~b.settled));
    return {piece, select(newA, cutA, zero) | select(newB, cutB, zero), order.visible,
            odd | ~(order.gone | (order.visible & ~open))};
}

} // namespace
} // namespace clipping
