// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/crossing.h"
#include "clipping/batch/polygon_table.h"

// The algorithm of polygon/exact.cpp, on a vector of segments at once. A lane in which a corner is
// too near the line, or an end too near an edge, is left unsettled.

namespace clipping {
namespace {

/// The polygon, with what does not depend on the segments in every lane.
template <class V>
struct PolygonInLanes {
    const PolygonTable& table;
    V centreX, centreY, halfWidth, halfHeight;

    CLIPPING_INLINE explicit PolygonInLanes(const PolygonTable& t)
        : table(t), centreX(V::of(t.box.centreX)), centreY(V::of(t.box.centreY)),
          halfWidth(V::of(t.box.halfWidth)), halfHeight(V::of(t.box.halfHeight))
    {
    }
    CLIPPING_INLINE V look(const double* numbers, V indices) const
    {
        return table.size <= 8 ? V::lookInEight(numbers, indices) : V::look(numbers, indices);
    }
};

/// The edges that the lines cross, as indices.
template <class V>
struct Crossed {
    V enter, leave;
    typename V::Mask any, unsure;
};

/// The side of the line on which corner c lies is the sign of d x (c - a). With the centre m of the
/// box it is computed as d x (c - m) + d x (m - a), the last term once a lane. Each of the four
/// products is off by 3e (two differences, itself) and passes at most three sums: together less
/// than 6.1 e (|dx| (|cy - my| + |ay - my|) + |dy| (|cx - mx| + |ax - mx|)); 8e allows for the
/// rounding of the bound.
template <class V>
CLIPPING_INLINE Crossed<V> crossed(const Ends<V>& s, V dx, V dy, const PolygonInLanes<V>& polygon)
{
    const PolygonTable& t = polygon.table;
    const V ax = s.ax - polygon.centreX, ay = s.ay - polygon.centreY;
    const V offset = fnma(dx, ay, dy * ax);
    const V bound =
        fma(abs(dx) * (polygon.halfHeight + abs(ay)) + abs(dy) * (polygon.halfWidth + abs(ax)),
            V::of(0x1p-50), V::of(tiny));
    const V negative = V::of(0) - bound;
    const auto side = [&](std::size_t i) {
        return fma(dx, V::of(t.offY[i]), fnma(dy, V::of(t.offX[i]), offset));
    };
    auto wasLeft = side(t.size - 1) > bound;
    auto any = wasLeft & ~wasLeft, unsure = any;
    V enter = V::ofBits(0), leave = enter;
    for (std::size_t i = 0, edge = t.size - 1; i < t.size; edge = i++) {
        const V value = side(i);
        const auto left = value > bound;
        unsure = unsure | ~(left | (value < negative));
        const auto falls = wasLeft & ~left;
        enter = select(falls, V::ofBits(edge), enter);
        leave = select(left & ~wasLeft, V::ofBits(edge), leave);
        any = any | falls;
        wasLeft = left;
    }
    return {enter, leave, any, unsure};
}

/// Edges of the polygon, one in each lane.
template <class V>
struct EdgeInLanes {
    V x, y;               ///< the first corner
    VectorPair<V> ex, ey; ///< the extent
};
template <class V>
CLIPPING_INLINE EdgeInLanes<V> edgeAt(V indices, const PolygonInLanes<V>& polygon)
{
    const PolygonTable& t = polygon.table;
    const auto look = [&](const double* numbers) { return polygon.look(numbers, indices); };
    return {look(t.cornerX),
            look(t.cornerY),
            {look(t.edgeX), look(t.edgeXLow)},
            {look(t.edgeY), look(t.edgeYLow)}};
}

/// On which side of an edge a point is; neither: too near to tell (orderBound).
template <class V>
struct Side {
    typename V::Mask inside, outside;
};
template <class V>
CLIPPING_INLINE Side<V> sideOf(V x, V y, const EdgeInLanes<V>& edge)
{
    const V p = (edge.x - x) * edge.ey.high, q = (edge.y - y) * edge.ex.high, depth = p - q;
    const V bound = fma(abs(p) + abs(q), V::of(orderBound), V::of(tiny));
    return {depth > bound, depth < V::of(0) - bound};
}

/// `Determinant` of exact/meeting.h.
template <class V>
struct DeterminantInLanes {
    V high, low, size;
};
template <class V>
CLIPPING_INLINE DeterminantInLanes<V> determinant(const VectorPair<V>& ux, const VectorPair<V>& uy,
                                                  const VectorPair<V>& vx, const VectorPair<V>& vy)
{
    const V p = ux.high * vy.high, q = uy.high * vx.high, high = p - q;
    const V lowP = fma(ux.low, vy.high, fma(ux.high, vy.low, restOfProduct(ux.high, vy.high, p)));
    const V lowQ = fma(uy.low, vx.high, fma(uy.high, vx.low, restOfProduct(uy.high, vx.high, q)));
    return {high, lowOfDifference(p, q, high) + (lowP - lowQ), abs(p) + abs(q)};
}

/// `Share` of exact/meeting.h.
template <class V>
struct ShareInLanes {
    V high, low, spread, skew;
    typename V::Mask tame;
};
template <class V>
CLIPPING_INLINE ShareInLanes<V> shareOf(const DeterminantInLanes<V>& n,
                                        const DeterminantInLanes<V>& d)
{
    const V high = d.high + d.low, low = d.low - (high - d.high), inverse = V::of(1) / high;
    const V share = n.high * inverse;
    const V rest = (n.low - share * low) - restOfProduct(share, high, n.high);
    const V size = abs(inverse), least = V::of(smallestMeeting), most = V::of(largestMeeting);
    return {share, rest * inverse, n.size * size, d.size * size,
            (n.size >= least) & (n.size <= most) & (d.size >= least) & (d.size <= most)
                & (abs(high) > d.size * V::of(meetingBound))};
}

/// `coordinateAt` of exact/meeting.h; the line's or the edge's own coordinate where that is known.
template <class V>
CLIPPING_INLINE Crossing<V> coordinateAt(const ShareInLanes<V>& t, V start,
                                         const VectorPair<V>& way, V edgeStart, V edgeWay)
{
    const V p = way.high * t.high;
    const V low = fma(way.low, t.high, fma(way.high, t.low, restOfProduct(way.high, t.high, p)));
    const V s = start + p, ofP = s - start;
    const V rest = ((start - (s - ofP)) + (p - ofP)) + low;
    const V error = V::of(quotientBound) * (fma(abs(way.high), t.spread, abs(p) * t.skew) + abs(s));
    const V below = s + (rest - error), above = s + (rest + error), zero = V::of(0);
    const auto upright = way.high == zero, onEdge = edgeWay == zero;
    return {select(upright, start, select(onEdge, edgeStart, below)) + zero, // never -0
            upright | onEdge
                | (t.tame & (error >= V::of(smallestMeetingBound)) & (below == above))};
}

/// `meeting` of exact/meeting.h.
template <class V>
struct Meeting {
    V x, y;
    typename V::Mask settled;
};
template <class V>
CLIPPING_INLINE Meeting<V> meeting(const Ends<V>& s, const VectorPair<V>& wayX,
                                   const VectorPair<V>& wayY, const EdgeInLanes<V>& edge)
{
    const auto off = [](V to, V from) {
        const V difference = to - from;
        return VectorPair<V>{difference, lowOfDifference(to, from, difference)};
    };
    const auto share = shareOf(determinant(off(edge.x, s.ax), off(edge.y, s.ay), edge.ex, edge.ey),
                               determinant(wayX, wayY, edge.ex, edge.ey));
    const auto x = coordinateAt(share, s.ax, wayX, edge.x, edge.ex.high);
    const auto y = coordinateAt(share, s.ay, wayY, edge.y, edge.ey.high);
    return {x.value, y.value, x.settled & y.settled};
}

template <class V>
CLIPPING_INLINE Clip<V> clipPolygonLanes(const Ends<V>& s, const PolygonInLanes<V>& polygon)
{
    const V dx = s.bx - s.ax, dy = s.by - s.ay, zero = V::of(0);
    const Crossed<V> edges = crossed(s, dx, dy, polygon);
    const auto enter = edgeAt(edges.enter, polygon), leave = edgeAt(edges.leave, polygon);
    const auto bEnters = sideOf(s.bx, s.by, enter), aLeaves = sideOf(s.ax, s.ay, leave);
    const auto a = sideOf(s.ax, s.ay, enter), b = sideOf(s.bx, s.by, leave);
    const auto gone = ~edges.any | bEnters.outside | aLeaves.outside;
    const auto visible = edges.any & bEnters.inside & aLeaves.inside;
    const auto known = visible & (a.inside | a.outside) & (b.inside | b.outside);
    if (!any(visible & (a.outside | b.outside)))
        return {s, zero, visible, edges.unsure | ~(gone | known)};

    const VectorPair<V> wayX{dx, lowOfDifference(s.bx, s.ax, dx)};
    const VectorPair<V> wayY{dy, lowOfDifference(s.by, s.ay, dy)};
    const auto newA = meeting(s, wayX, wayY, enter), newB = meeting(s, wayX, wayY, leave);
    const Ends<V> piece{select(a.outside, newA.x, s.ax), select(a.outside, newA.y, s.ay),
                        select(b.outside, newB.x, s.bx), select(b.outside, newB.y, s.by)};
    const auto movedA = ~((piece.ax == s.ax) & (piece.ay == s.ay));
    const auto movedB = ~((piece.bx == s.bx) & (piece.by == s.by));
    const auto open = (a.outside & ~newA.settled) | (b.outside & ~newB.settled);
    const PolygonTable& t = polygon.table;
    return {piece,
            select(movedA, polygon.look(t.numberForA, edges.enter), zero)
                | select(movedB, polygon.look(t.numberForB, edges.leave), zero),
            visible, edges.unsure | ~(gone | (known & ~open))};
}

} // namespace
} // namespace clipping
