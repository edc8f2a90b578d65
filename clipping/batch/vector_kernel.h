// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/sets.h"
#include "clipping/exact/bounds.h"

// `exact` in vectors, written once for every set of instructions. A file that includes this is
// compiled for instructions that the processor may lack; so everything here is in an anonymous
// namespace and nothing from elsewhere is instantiated, lest the linker keep a copy of an inline
// function that only some processors can run.
//
// A file's `Lanes` wraps its vectors of doubles, its `Wide<T>` those of T for the first pass.

namespace clipping {
namespace {

#define CLIPPING_INLINE [[gnu::always_inline]] inline

/// The four coordinates of as many segments as a vector has lanes.
template <class V>
struct Ends {
    V ax, ay, bx, by;
};

/// First pass: writes the indices of the segments that may be visible, returns how many.
template <class V, class T>
CLIPPING_INLINE std::size_t survivorsOf(const BasicSegment<T>* segments, std::size_t first,
                                        std::size_t last, const Box<T>& box, std::uint32_t* indices)
{
    constexpr std::size_t ahead = 2048 / sizeof(BasicSegment<T>); // 2 KiB
    const V minX = V::of(box.window.min.x), minY = V::of(box.window.min.y);
    const V maxX = V::of(box.window.max.x), maxY = V::of(box.window.max.y);
    const V centreX = V::of(box.centreX), centreY = V::of(box.centreY);
    const V halfWidth = V::of(box.halfWidth), halfHeight = V::of(box.halfHeight);
    const V relative = V::of(missBound<T>), absolute = V::of(missTiny<T>);
    std::size_t count = 0, i = first;
    for (; i + V::width <= last; i += V::width) {
        for (std::size_t line = 0; line < V::width; line += 64 / sizeof(BasicSegment<T>))
            __builtin_prefetch(segments + i + ahead + line);
        const Ends<V> s = V::load(segments + i);
        const auto beyond = (max(s.ax, s.bx) < minX) | (min(s.ax, s.bx) > maxX)
                            | (max(s.ay, s.by) < minY) | (min(s.ay, s.by) > maxY);
        const V dx = s.bx - s.ax, dy = s.by - s.ay;
        const V p = (s.ax - centreX) * dy, q = (s.ay - centreY) * dx;
        const V reach = fma(halfWidth, abs(dy), halfHeight * abs(dx));
        const V bound = fma(reach + abs(p) + abs(q), relative, absolute);
        const auto misses = abs(p - q) > reach + bound;
        count += V::storeIndices(indices + count, i, ~(beyond | misses));
    }
    for (; i < last; ++i)
        indices[count++] = static_cast<std::uint32_t>(i);
    return count;
}

/// A number and what it lacks, in every lane.
template <class V>
struct VectorPair {
    V high, low;
};

template <class V>
CLIPPING_INLINE VectorPair<V> twoDifference(V a, V b)
{
    const V difference = a - b;
    const V ofB = difference - a;
    return {difference, (a - (difference - ofB)) - (b + ofB)};
}

/// `crossing` of exact/line.h in every lane: start + rise * run / length, and where that is proved
/// to be rounded as the truth is. All of rise, run and length are >= 0 in lanes that matter.
template <class V>
struct Crossing {
    V value;
    typename V::Mask settled;
};
template <class T, class V>
CLIPPING_INLINE Crossing<V> crossing(V start, VectorPair<V> rise, VectorPair<V> run,
                                     VectorPair<V> length)
{
    const V p = rise.high * run.high;
    const V low = fma(rise.low, run.high, fma(rise.high, run.low, fms(rise.high, run.high, p)));
    const V inverse = V::of(1) / length.high;
    const V q = p * inverse;
    const V rest = fnma(q, length.low, fnma(q, length.high, p) + low);
    const V s = start + q, ofQ = s - start;
    const V t = fma(rest, inverse, (start - (s - ofQ)) + (q - ofQ));
    const V error = V::of(crossingBound<T>) * (q + abs(s));
    const V below = (s + (t - error)).template rounded<T>();
    const V above = (s + (t + error)).template rounded<T>();
    const auto tame = ((p >= V::of(smallestProduct)) & (p <= V::of(largestProduct))
                       & (q >= V::of(smallestQuotient)) & (q <= V::of(largestQuotient)))
                      | (rise.high == V::of(0));
    return {below, tame & (below == above)};
}

/// What became of a vector of segments.
template <class V>
struct Clip {
    Ends<V> piece;
    V cut; ///< as bits: what `cut` is, in the upper half of each lane
    typename V::Mask visible, unsettled;
};

/// The window in every lane, and mirrored for segments that run left or down.
template <class V>
struct VectorWindow {
    V minX, minY, maxX, maxY;
};

/// The edges of new ends as `edgeAt` names them, shifted into place, where `isNew`.
template <class V>
CLIPPING_INLINE V edgesAt(V x, V y, typename V::Mask isNew, const VectorWindow<V>& w, int shift)
{
    const auto edge = [shift](Edge e) { return V::ofBits(std::uint64_t(e) << (32 + shift)); };
    V result = select(y == w.minY, edge(Edge::Bottom), edge(Edge::Top));
    result = select(x == w.maxX, edge(Edge::Right), result);
    result = select(x == w.minX, edge(Edge::Left), result);
    return select(isNew, result, V::of(0));
}

/// The algorithm of algorithms/exact.cpp, on segments mirrored so that they run right and up: then
/// the near edges are the left and bottom ones, and no product that matters is negative.
template <class T, class V>
CLIPPING_INLINE Clip<V> clipLanes(const Ends<V>& original, const VectorWindow<V>& w)
{
    const V signX = signOf(original.bx - original.ax), signY = signOf(original.by - original.ay);
    const V ax = original.ax ^ signX, bx = original.bx ^ signX;
    const V ay = original.ay ^ signY, by = original.by ^ signY;
    const V nearX = select(signX, w.maxX, w.minX) ^ signX;
    const V farX = select(signX, w.minX, w.maxX) ^ signX;
    const V nearY = select(signY, w.maxY, w.minY) ^ signY;
    const V farY = select(signY, w.minY, w.maxY) ^ signY;
    const auto enterX = ax<nearX, enterY = ay<nearY, leaveX = bx> farX, leaveY = by> farY;
    const auto beyond = (bx < nearX) | (ax > farX) | (by < nearY) | (ay > farY);

    const auto dx = twoDifference(bx, ax), dy = twoDifference(by, ay);
    const V largest = V::of(std::numeric_limits<double>::max());
    const auto finite = (dx.high <= largest) & (dy.high <= largest);
    const auto touched = enterX | enterY | leaveX | leaveY | ~finite;
    if (!any(touched))
        return {original, V::of(0), ~touched, touched};

    // What the order of two crossings is the sign of: x's product minus y's.
    const V pNear = (nearX - ax) * dy.high, qNear = (nearY - ay) * dx.high;
    const V pFar = (farX - ax) * dy.high, qFar = (farY - ay) * dx.high;
    const auto later = [](V p, V q) { return p - q > fma(p + q, V::of(orderBound), V::of(tiny)); };
    const auto missX = enterX & leaveY, missY = enterY & leaveX;
    const auto corner = enterX & enterY, farCorner = leaveX & leaveY;
    const auto misses = beyond | (missX & later(pNear, qFar)) | (missY & later(qNear, pFar));
    const auto enterByX = enterX & (~enterY | later(pNear, qNear));
    const auto leaveByX = leaveX & (~leaveY | later(qFar, pFar));
    const auto open = (missX & ~later(qFar, pNear)) | (missY & ~later(pFar, qNear))
                      | (corner & ~enterByX & ~later(qNear, pNear))
                      | (farCorner & ~leaveByX & ~later(pFar, qFar));

    const auto end = [&](typename V::Mask byX, V edgeX, V edgeY) {
        const V from = select(byX, ax, ay), start = select(byX, ay, ax);
        const VectorPair<V> rise{select(byX, dy.high, dx.high), select(byX, dy.low, dx.low)};
        const VectorPair<V> length{select(byX, dx.high, dy.high), select(byX, dx.low, dy.low)};
        const auto run = twoDifference(select(byX, edgeX, edgeY), from);
        return crossing<T>(start, rise, run, length);
    };
    const auto newA = enterX | enterY, newB = leaveX | leaveY;
    const auto a = end(enterByX, nearX, nearY), b = end(leaveByX, farX, farY);
    const auto place = [](typename V::Mask isNew, typename V::Mask onEdge, V edge, V value, V sign,
                          V old) {
        return select(isNew, select(onEdge, edge ^ sign, (value ^ sign) + V::of(0)), old);
    };
    const Ends<V> piece{place(newA, enterByX, nearX, a.value, signX, original.ax),
                        place(newA, ~enterByX, nearY, a.value, signY, original.ay),
                        place(newB, leaveByX, farX, b.value, signX, original.bx),
                        place(newB, ~leaveByX, farY, b.value, signY, original.by)};
    const V cut = edgesAt(piece.ax, piece.ay, newA, w, 0) | edgesAt(piece.bx, piece.by, newB, w, 8);
    const auto unsettled = ~misses & (~finite | open | (newA & ~a.settled) | (newB & ~b.settled));
    return {piece, cut, ~misses, unsettled};
}

/// Second pass: clips the segments at `indices`, which has room to be filled up to whole vectors.
template <class V, class T>
CLIPPING_INLINE BatchResult clipSurvivors(const Batch<T>& batch, std::uint32_t* indices,
                                          std::size_t count, BasicClipped<BasicSegment<T>>* out)
{
    const VectorWindow<V> w{V::of(batch.window.min.x), V::of(batch.window.min.y),
                            V::of(batch.window.max.x), V::of(batch.window.max.y)};
    for (std::size_t i = 0; i < V::width; ++i)
        indices[count + i] = indices[count - 1];
    BatchResult result{};
    for (std::size_t i = 0; i < count; i += V::width) {
        const std::size_t lanes = count - i < V::width ? count - i : V::width;
        const unsigned used = (1u << lanes) - 1;
        const Clip<V> clip = clipLanes<T>(V::gather(batch.segments, indices + i), w);
        if (const unsigned unsettled = bits(clip.unsettled) & used) {
            result.unsettled += static_cast<std::size_t>(__builtin_popcount(unsettled));
            result.pieces +=
                clipOneByOne(batch.segments, indices + i, lanes, batch.window, out + result.pieces);
        } else {
            V::store(out + result.pieces, clip, indices + i, bits(clip.visible) & used, lanes);
            result.pieces +=
                static_cast<std::size_t>(__builtin_popcount(bits(clip.visible) & used));
        }
    }
    return result;
}

template <class V, class First, class T>
CLIPPING_INLINE BatchResult clipInVectors(const Batch<T>& batch)
{
    if (!legal(batch.window))
        return {};
    const Box<T> box = boxOf(batch.window);
    std::uint32_t indices[blockSize + V::width + First::width];
    BatchResult result{};
    for (std::size_t first = batch.begin; first < batch.end; first += blockSize) {
        const std::size_t last = batch.end - first < blockSize ? batch.end : first + blockSize;
        const std::size_t count = survivorsOf<First>(batch.segments, first, last, box, indices);
        if (count == 0)
            continue;
        const BatchResult block =
            clipSurvivors<V>(batch, indices, count, batch.out + result.pieces);
        result.pieces += block.pieces;
        result.unsettled += block.unsettled;
    }
    return result;
}

} // namespace
} // namespace clipping
