// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/crossing.h"
#include "clipping/batch/polygon_table.h"

// The algorithm of polygon/exact.cpp, on a vector of segments at once. A lane in which a corner is
// too near the line, or an end too near an edge, is left unsettled.

namespace clipping {
namespace {

/// The polygon, with what does not depend on the segments in every lane; `few`: up to eight
/// corners.
template <class V, bool few>
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
        if constexpr (few)
            return V::lookInEight(numbers, indices);
        else
            return V::look(numbers, indices);
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
template <class V, bool few>
CLIPPING_INLINE Crossed<V> crossed(const Ends<V>& s, V dx, V dy,
                                   const PolygonInLanes<V, few>& polygon)
{
    const PolygonTable& t = polygon.table;
    const V ax = s.ax - polygon.centreX, ay = s.ay - polygon.centreY;
    const V offset = fnma(dx, ay, dy * ax);
    const V bound =
        fma(abs(dx) * (polygon.halfHeight + abs(ay)) + abs(dy) * (polygon.halfWidth + abs(ax)),
            V::of(0x1p-50), V::of(tiny));
    const auto side = [&](std::size_t i) {
        return fma(dx, V::of(t.offY[i]), fnma(dy, V::of(t.offX[i]), offset));
    };
    const V zero = V::of(0), last = side(t.size - 1);
    auto wasLeft = last > zero, any = last < last;
    V enter = V::ofBits(0), leave = enter, least = abs(last), edge = V::of(t.index[t.size - 1]);
    for (std::size_t i = 0; i < t.size; ++i) {
        const V value = side(i);
        const auto left = value > zero, falls = wasLeft & ~left;
        least = min(least, abs(value));
        enter = select(falls, edge, enter);
        leave = select(left & ~wasLeft, edge, leave);
        any = any | falls;
        wasLeft = left;
        edge = V::of(t.index[i]);
    }
    return {enter, leave, any,
            ~(least > bound)}; // where a value is NaN, so is the bound, or infinite
}

/// Edges of the polygon, one in each lane.
template <class V>
struct EdgeInLanes {
    V x, y;               ///< the first corner
    VectorPair<V> ex, ey; ///< the extent
    V reach;              ///< PolygonTable::reach
};
template <class V, bool few>
CLIPPING_INLINE EdgeInLanes<V> edgeAt(V indices, const PolygonInLanes<V, few>& polygon)
{
    const PolygonTable& t = polygon.table;
    const auto look = [&](const double* numbers) { return polygon.look(numbers, indices); };
    return {look(t.cornerX),
            look(t.cornerY),
            {look(t.edgeX), look(t.edgeXLow)},
            {look(t.edgeY), look(t.edgeYLow)},
            look(t.reach)};
}

/// Where the ends of segments lie at an edge, and what that is decided by: n = (c - a) x e,
/// positive if a is inside, and d = (b - a) x e, for the edge from c with the extent e. Neither
/// inside nor outside: too near to tell.
template <class V>
struct AtEdge {
    V n, d, sizeOfN, sizeOfD; ///< the sizes: sums of the magnitudes of two products
    typename V::Mask aInside, aOutside, bInside, bOutside;
};
/// n and d are off by 4e of their sizes each (orderBound), n - d by e more of both.
template <class V>
CLIPPING_INLINE AtEdge<V> atEdge(const Ends<V>& s, V dx, V dy, const EdgeInLanes<V>& edge)
{
    const V p = (edge.x - s.ax) * edge.ey.high, q = (edge.y - s.ay) * edge.ex.high;
    const V u = dx * edge.ey.high, v = dy * edge.ex.high;
    const V n = p - q, d = u - v, ofB = n - d;
    const V sizeOfN = abs(p) + abs(q), sizeOfD = abs(u) + abs(v);
    const V bound = fma(sizeOfN, V::of(orderBound), V::of(tiny));
    const V boundOfB = fma(sizeOfN + sizeOfD, V::of(2 * orderBound), V::of(tiny));
    const V zero = V::of(0);
    return {
        n, d, sizeOfN, sizeOfD, n > bound, n<zero - bound, ofB> boundOfB, ofB < zero - boundOfB};
}

/// Whether an extent is far enough from underflow for `nearBound`.
template <class V>
CLIPPING_INLINE typename V::Mask fine(V extent)
{
    return (abs(extent) >= V::of(smallestMeeting)) | (extent == V::of(0));
}

/// A coordinate of the point at the share t of the way, as a number and its rest.
template <class V>
CLIPPING_INLINE VectorPair<V> pointAt(V t, V start, const VectorPair<V>& way)
{
    const V p = t * way.high, s = start + p, ofP = s - start;
    const V rest = (start - (s - ofP)) + (p - ofP);
    return {s, rest + fma(t, way.low, restOfProduct(t, way.high, p))};
}

/// Where the lines meet, as exact/meeting.h has it, in lanes whose ends are on different sides of
/// the edge; bounds.h proves `nearBound`. The share t = n / d is computed once in double. The point
/// there misses the edge by r = (c - point) x e, which is small, so that few digits of r correct
/// the point.
template <class V>
struct Meeting {
    V x, y;
    typename V::Mask settled;
};
template <class V>
CLIPPING_INLINE Meeting<V> meeting(const Ends<V>& s, const VectorPair<V>& wayX,
                                   const VectorPair<V>& wayY, const EdgeInLanes<V>& edge,
                                   const AtEdge<V>& at, bool hasAxisAligned)
{
    const V inverse = V::of(1) / at.d, t = at.n * inverse;
    const auto x = pointAt(t, s.ax, wayX), y = pointAt(t, s.ay, wayY);
    const V offX = edge.x - x.high, offY = edge.y - y.high;
    const V lowX = lowOfDifference(edge.x, x.high, offX) - x.low;
    const V lowY = lowOfDifference(edge.y, y.high, offY) - y.low;
    const V p = offX * edge.ey.high, q = offY * edge.ex.high;
    const V rests = restOfProduct(offX, edge.ey.high, p) - restOfProduct(offY, edge.ex.high, q);
    const V low = fnma(offY, edge.ex.low,
                       fma(offX, edge.ey.low, fnma(lowY, edge.ex.high, lowX * edge.ey.high)));
    const V more = (((p - q) + rests) + low) * inverse;
    const V size = abs(inverse);
    const V doubt = (at.sizeOfN + at.sizeOfD + edge.reach) * size
                    * fma(at.sizeOfD * size, V::of(steepBound), V::of(nearBound));
    const auto tame = (abs(at.d) > at.sizeOfD * V::of(steepest))
                      & (at.sizeOfD >= V::of(smallestMeeting))
                      & (at.sizeOfD <= V::of(largestMeeting));
    const auto rounded = [&](const VectorPair<V>& point, V way, V edgeAt, V edgeWay) {
        const V rest = fma(more, way, point.low);
        const V error = fma(abs(way), doubt, abs(point.high) * V::of(nearSumBound));
        const V below = point.high + (rest - error), above = point.high + (rest + error);
        const Crossing<V> found{below, (below == above) & tame};
        const V zero = V::of(0);
        if (!hasAxisAligned) [[likely]]
            return Crossing<V>{found.value + zero, found.settled}; // never -0
        const auto onEdge = edgeWay == zero;
        return Crossing<V>{select(onEdge, edgeAt, found.value) + zero, found.settled | onEdge};
    };
    const auto foundX = rounded(x, wayX.high, edge.x, edge.ex.high);
    const auto foundY = rounded(y, wayY.high, edge.y, edge.ey.high);
    return {foundX.value, foundY.value, foundX.settled & foundY.settled};
}

template <class V, bool few>
CLIPPING_INLINE Clip<V> clipPolygonLanes(const Ends<V>& s, const PolygonInLanes<V, few>& polygon)
{
    const V dx = s.bx - s.ax, dy = s.by - s.ay, zero = V::of(0);
    const Crossed<V> edges = crossed(s, dx, dy, polygon);
    const auto enter = edgeAt(edges.enter, polygon), leave = edgeAt(edges.leave, polygon);
    const auto in = atEdge(s, dx, dy, enter), out = atEdge(s, dx, dy, leave);
    const auto gone = ~edges.any | in.bOutside | out.aOutside;
    const auto visible = edges.any & in.bInside & out.aInside;
    const auto newA = in.aOutside, newB = out.bOutside;
    const auto known = visible & (in.aInside | newA) & (out.bInside | newB);
    if (!any(visible & (newA | newB)))
        return {s, zero, visible, edges.unsure | ~(gone | known)};

    const VectorPair<V> wayX{dx, lowOfDifference(s.bx, s.ax, dx)};
    const VectorPair<V> wayY{dy, lowOfDifference(s.by, s.ay, dy)};
    const PolygonTable& t = polygon.table;
    Ends<V> piece = s;
    V cut = zero;
    auto open = ~(fine(dx) & fine(dy));
    if (any(visible & newA)) {
        const auto a = meeting(s, wayX, wayY, enter, in, t.hasAxisAligned);
        piece.ax = select(newA, a.x, s.ax), piece.ay = select(newA, a.y, s.ay);
        const auto unnamed = t.namesEveryCut ? ~newA : (piece.ax == s.ax) & (piece.ay == s.ay);
        cut = select(unnamed, zero, polygon.look(t.numberForA, edges.enter));
        open = open | (newA & ~a.settled);
    }
    if (any(visible & newB)) {
        const auto b = meeting(s, wayX, wayY, leave, out, t.hasAxisAligned);
        piece.bx = select(newB, b.x, s.bx), piece.by = select(newB, b.y, s.by);
        const auto unnamed = t.namesEveryCut ? ~newB : (piece.bx == s.bx) & (piece.by == s.by);
        cut = cut | select(unnamed, zero, polygon.look(t.numberForB, edges.leave));
        open = open | (newB & ~b.settled);
    }
    return {piece, cut, visible, edges.unsure | ~(gone | (known & ~open))};
}

} // namespace
} // namespace clipping
