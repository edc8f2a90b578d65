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
#define LANE [[maybe_unused]] CLIPPING_INLINE friend

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

/// What the difference of a and b lacks.
template <class V>
CLIPPING_INLINE V lowOfDifference(V a, V b, V difference)
{
    const V ofB = difference - a;
    return (a - (difference - ofB)) - (b + ofB);
}
template <class V>
CLIPPING_INLINE VectorPair<V> twoDifference(V a, V b)
{
    const V difference = a - b;
    return {difference, lowOfDifference(a, b, difference)};
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
                                     VectorPair<V> length, V inverse)
{
    if constexpr (sizeof(T) == sizeof(float)) {
        const V q = rise.high * run.high * inverse, sum = start + q;
        const V error = V::of(singleBound) * (q + abs(sum));
        const V below = (sum - error).template rounded<T>();
        const V above = (sum + error).template rounded<T>();
        return {below, below == above}; // floats cannot bring q to the ends of double's range
    }
    const V p = rise.high * run.high;
    const V low =
        fma(rise.low, run.high, fma(rise.high, run.low, restOfProduct(rise.high, run.high, p)));
    const V q = p * inverse;
    const V rest = fnma(q, length.low, low - restOfProduct(q, length.high, p));
    const V s = start + q, ofQ = s - start;
    const V t = fma(rest, inverse, (start - (s - ofQ)) + (q - ofQ));
    const V error = V::of(crossingBound<T>) * (q + abs(s));
    const V below = (s + (t - error)).template rounded<T>();
    const V above = (s + (t + error)).template rounded<T>();
    // Only underflow goes unnoticed: what overflows ends as NaN and is equal to nothing.
    const auto tame =
        ((p >= V::of(smallestProduct)) & (q >= V::of(smallestQuotient))) | (rise.high == V::of(0));
    return {below, tame & (below == above)};
}

/// What became of a vector of segments.
template <class V>
struct Clip {
    Ends<V> piece;
    V cut; ///< as bits: what `cut` is, in the upper half of each lane
    typename V::Mask visible, unsettled;
};

/// The window in every lane.
template <class V>
struct VectorWindow {
    V minX, minY, maxX, maxY;
};

/// What `cut` says where an end is on the edge of one axis or the other, shifted into place.
template <class V>
CLIPPING_INLINE V edgeBits(typename V::Mask byX, V sign, Edge positive, Edge negative, V signY,
                           Edge positiveY, Edge negativeY, int shift)
{
    const auto edge = [shift](Edge e) { return V::ofBits(std::uint64_t(e) << (32 + shift)); };
    return select(byX, select(sign, edge(negative), edge(positive)),
                  select(signY, edge(negativeY), edge(positiveY)));
}

/// The algorithm of algorithms/exact.cpp, on segments mirrored so that they run right and up: then
/// the near edges are the left and bottom ones. Crossings are ordered by how much of the segment
/// lies before them, which lies between 0 and 1 wherever it matters.
template <class T, class V>
CLIPPING_INLINE Clip<V> clipLanes(const Ends<V>& original, const VectorWindow<V>& w)
{
    const V zero = V::of(0), one = V::of(1), bound = V::of(parameterBound);
    const V signX = signOf(original.bx - original.ax), signY = signOf(original.by - original.ay);
    const V ax = original.ax ^ signX, bx = original.bx ^ signX;
    const V ay = original.ay ^ signY, by = original.by ^ signY;
    const V entryX = select(signX, w.maxX, w.minX), exitX = select(signX, w.minX, w.maxX);
    const V entryY = select(signY, w.maxY, w.minY), exitY = select(signY, w.minY, w.maxY);
    const V nearX = entryX ^ signX, farX = exitX ^ signX;
    const V nearY = entryY ^ signY, farY = exitY ^ signY;
    const auto newA = (ax < nearX) | (ay < nearY), newB = (bx > farX) | (by > farY);
    const auto dx = twoDifference(bx, ax), dy = twoDifference(by, ay);
    const auto odd = irregular(dx.high) | irregular(dy.high);
    const auto touched = newA | newB | odd;
    if (!any(touched))
        return {original, zero, ~touched, touched};

    const V ux = nearX - ax, uy = nearY - ay, vx = farX - ax, vy = farY - ay;
    const V inverseX = one / dx.high, inverseY = one / dy.high;
    // Where a difference is 0, a quotient may be NaN; max and min then give the second.
    const V enterX = max(ux * inverseX, zero), enterY = max(uy * inverseY, zero);
    const V leaveX = min(vx * inverseX, one), leaveY = min(vy * inverseY, one);
    const V shown = min(leaveX, leaveY) - max(enterX, enterY);
    const V entryOrder = enterX - enterY, exitOrder = leaveY - leaveX;
    const auto visible = shown > bound, gone = shown < V::of(-parameterBound);
    const auto enterByX = entryOrder > zero, leaveByX = exitOrder > zero;

    const auto end = [&](typename V::Mask byX, V edgeX, V edgeY, V runX, V runY) {
        const V start = select(byX, ay, ax), inverse = select(byX, inverseX, inverseY);
        const VectorPair<V> rise{select(byX, dy.high, dx.high), select(byX, dy.low, dx.low)};
        const VectorPair<V> length{select(byX, dx.high, dy.high), select(byX, dx.low, dy.low)};
        const V run = select(byX, runX, runY);
        const V low = lowOfDifference(select(byX, edgeX, edgeY), select(byX, ax, ay), run);
        return crossing<T>(start, rise, {run, low}, length, inverse);
    };
    const auto a = end(enterByX, nearX, nearY, ux, uy), b = end(leaveByX, farX, farY, vx, vy);
    const auto place = [zero](typename V::Mask isNew, typename V::Mask onEdge, V edge, V value,
                              V sign, V old) {
        return select(isNew, select(onEdge, edge, (value ^ sign) + zero), old); // never -0
    };
    const Ends<V> piece{place(newA, enterByX, entryX, a.value, signX, original.ax),
                        place(newA, ~enterByX, entryY, a.value, signY, original.ay),
                        place(newB, leaveByX, exitX, b.value, signX, original.bx),
                        place(newB, ~leaveByX, exitY, b.value, signY, original.by)};
    const V cutA =
        edgeBits(enterByX, signX, Edge::Left, Edge::Right, signY, Edge::Bottom, Edge::Top, 0);
    const V cutB =
        edgeBits(leaveByX, signX, Edge::Right, Edge::Left, signY, Edge::Top, Edge::Bottom, 8);
    const auto openA = newA & (~(abs(entryOrder) > bound) | ~a.settled);
    const auto openB = newB & (~(abs(exitOrder) > bound) | ~b.settled);
    return {piece, select(newA, cutA, zero) | select(newB, cutB, zero), visible,
            odd | ~(gone | (visible & ~(openA | openB)))};
}

/// Second pass: clips the segments at `indices`, which has room to be filled up to whole vectors,
/// into `out`, which has room for `room`. Meanwhile fetches what the next block will read.
template <class V, class T>
CLIPPING_INLINE BatchResult clipSurvivors(const Batch<T>& batch, std::uint32_t* indices,
                                          std::size_t count, const BasicSegment<T>* next,
                                          BasicClipped<BasicSegment<T>>* out, std::size_t room)
{
    const VectorWindow<V> w{V::of(batch.window.min.x), V::of(batch.window.min.y),
                            V::of(batch.window.max.x), V::of(batch.window.max.y)};
    BatchResult result{};
    for (std::size_t lane = count; lane < count + V::width; ++lane)
        indices[lane] = static_cast<std::uint32_t>(batch.begin);
    const char* line = reinterpret_cast<const char*>(next);
    const char* const end = reinterpret_cast<const char*>(next + blockSize);
    for (std::size_t i = 0; i < count; i += V::width) {
        for (int ahead = 0; ahead < 8 && line < end; ++ahead, line += 64)
            __builtin_prefetch(line);
        const std::size_t lanes = count - i < V::width ? count - i : V::width;
        const unsigned used = (1u << lanes) - 1;
        const auto clip = clipLanes<T>(V::gather(batch.segments, indices + i), w);
        const unsigned unsettled = bits(clip.unsettled) & used;
        if (unsettled != 0 || result.pieces + V::width > room) {
            result.unsettled += static_cast<std::size_t>(__builtin_popcount(unsettled));
            result.pieces +=
                clipOneByOne(batch.segments, indices + i, lanes, batch.window, out + result.pieces);
            continue;
        }
        const unsigned visible = bits(clip.visible) & used;
        V::store(out + result.pieces, clip, indices + i, visible);
        result.pieces += static_cast<std::size_t>(__builtin_popcount(visible));
    }
    return result;
}

template <class V, class First, class T>
CLIPPING_INLINE BatchResult clipInVectors(const Batch<T>& batch)
{
    if (!canShow(batch.window))
        return {};
    const Box<T> box = boxOf(batch.window);
    std::uint32_t indices[blockSize + V::width + First::width];
    BatchResult result{};
    for (std::size_t first = batch.begin; first < batch.end; first += blockSize) {
        const std::size_t last = batch.end - first < blockSize ? batch.end : first + blockSize;
        const std::size_t count = survivorsOf<First>(batch.segments, first, last, box, indices);
        const BatchResult block =
            clipSurvivors<V>(batch, indices, count, batch.segments + last,
                             batch.out + result.pieces, batch.end - batch.begin - result.pieces);
        result.pieces += block.pieces;
        result.unsettled += block.unsettled;
    }
    return result;
}

} // namespace
} // namespace clipping
