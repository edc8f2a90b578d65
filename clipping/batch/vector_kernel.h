// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/clip_lanes.h"
#include "clipping/batch/polygon_lanes.h"
#include "clipping/batch/streaming.h"
#include "clipping/batch/survivors.h"

// `exact` in vectors, written once for every instruction set (lanes.h says what the including file
// must observe). Block by block, it first rejects segments that cannot be visible, then clips the
// rest.
//
// The including file's `V` wraps its vectors of doubles, its `First` the vectors of T for the first
// pass. A shape is what the segments are clipped at: a window or a polygon.

namespace clipping {
namespace {

/// The window of a batch, for these passes.
template <class T>
struct WindowShape {
    using Number = T;
    static constexpr Care usual = usualCare<T>, most = mostCare<T>;
    const Batch<T>& batch;
    const Box<T> box = boxOf(batch.window);

    template <class V>
    CLIPPING_INLINE VectorWindow<V> inLanes() const
    {
        return inEveryLane<V>(batch.window);
    }
    template <Care care, class V>
    CLIPPING_INLINE Clip<V> clip(const Ends<V>& s, const VectorWindow<V>& w) const
    {
        return clipLanes<care>(s, w);
    }
    template <class First>
    CLIPPING_INLINE std::size_t survivors(std::size_t first, std::size_t last,
                                          std::uint32_t* indices) const
    {
        return survivorsOf<First>(batch.segments, first, last, box, WindowReach<First>(box),
                                  indices);
    }
    template <class First>
    CLIPPING_INLINE bool isUntouched(std::size_t first, std::size_t last) const
    {
        return untouched<First>(batch.segments, first, last, batch.window);
    }
    CLIPPING_INLINE bool byVectors() const { return true; }
    std::size_t oneByOne(const std::uint32_t* indices, std::size_t count,
                         BasicClipped<BasicSegment<T>>* out) const
    {
        return clipOneByOne(batch.segments, indices, count, batch.window, out);
    }
};

/// The same for a polygon. Its bounding box and an enclosing parallelogram reject.
template <bool few>
struct PolygonShape {
    using Number = double;
    static constexpr Care usual = Care::Doubles, most = Care::Doubles;
    const PolygonBatch& batch;

    template <class V>
    CLIPPING_INLINE PolygonInLanes<V, few> inLanes() const
    {
        return PolygonInLanes<V, few>(*batch.table);
    }
    template <Care, class V>
    CLIPPING_INLINE Clip<V> clip(const Ends<V>& s, const PolygonInLanes<V, few>& polygon) const
    {
        return clipPolygonLanes(s, polygon);
    }
    template <class First>
    CLIPPING_INLINE std::size_t survivors(std::size_t first, std::size_t last,
                                          std::uint32_t* indices) const
    {
        return survivorsOf<First>(batch.segments, first, last, batch.table->box,
                                  TurnedReach<First>(*batch.table), indices);
    }
    template <class First>
    CLIPPING_INLINE bool isUntouched(std::size_t, std::size_t) const
    {
        return false;
    }
    CLIPPING_INLINE bool byVectors() const { return batch.table->size <= mostVectorCorners; }
    std::size_t oneByOne(const std::uint32_t* indices, std::size_t count, Clipped* out) const
    {
        return clipOneByOne(batch.segments, indices, count, *batch.polygon, out);
    }
};

/// Handles the vectors of the second pass that are not settled at once, or that do not fit whole
/// into the remaining room. A separate function, to keep the common path small.
template <class V, class Shape, class T = typename Shape::Number>
[[gnu::noinline, gnu::cold]] BatchResult
clipWithCare(const Shape& shape, const std::uint32_t* indices, std::size_t lanes,
             BasicClipped<BasicSegment<T>>* out, std::size_t room)
{
    const unsigned used = (1u << lanes) - 1;
    const auto clip = shape.template clip<Shape::most>(V::gather(shape.batch.segments, indices),
                                                       shape.template inLanes<V>());
    const unsigned unsettled = bits(clip.unsettled) & used, visible = bits(clip.visible) & used;
    if (unsettled == 0 && V::width <= room) {
        V::store(out, clip, indices, visible);
        return {static_cast<std::size_t>(__builtin_popcount(visible)), 0};
    }
    return {shape.oneByOne(indices, lanes, out),
            static_cast<std::size_t>(__builtin_popcount(unsettled))};
}

/// Second pass: clips the segments at `indices`, which has room to be padded to whole vectors, into
/// `out`, which has room for `room` pieces. Meanwhile prefetches what the next block will read.
template <class V, class Shape, class T = typename Shape::Number>
// NOLINTNEXTLINE(readability-function-size): needs input, output and the next block
CLIPPING_INLINE BatchResult clipSurvivors(const Shape& shape, std::uint32_t* indices,
                                          std::size_t count, const BasicSegment<T>* next,
                                          BasicClipped<BasicSegment<T>>* out, std::size_t room)
{
    const auto& batch = shape.batch;
    const auto inLanes = shape.template inLanes<V>();
    BatchResult result{};
    for (std::size_t lane = count; lane < count + V::width; ++lane)
        indices[lane] = static_cast<std::uint32_t>(batch.begin);
    // An integer, because the address may be behind the array.
    auto line = reinterpret_cast<std::uintptr_t>(next);
    const std::uintptr_t end = line + blockSize * sizeof *next;
    for (std::size_t i = 0; i < count; i += V::width) {
        for (int ahead = 0; ahead < 8 && line < end; ++ahead, line += 64)
            __builtin_prefetch(
                reinterpret_cast<const void*>(line)); // NOLINT(performance-no-int-to-ptr)
        const std::size_t lanes = count - i < V::width ? count - i : V::width;
        const unsigned used = (1u << lanes) - 1;
        const auto clip =
            shape.template clip<Shape::usual>(V::gather(batch.segments, indices + i), inLanes);
        if ((bits(clip.unsettled) & used) != 0 || result.pieces + V::width > room) {
            const auto careful = clipWithCare<V>(shape, indices + i, lanes, out + result.pieces,
                                                 room - result.pieces);
            result.pieces += careful.pieces;
            result.unsettled += careful.unsettled;
            continue;
        }
        const unsigned visible = bits(clip.visible) & used;
        V::store(out + result.pieces, clip, indices + i, visible);
        result.pieces += static_cast<std::size_t>(__builtin_popcount(visible));
    }
    return result;
}

/// Copies a block that is wholly inside.
template <class T>
CLIPPING_INLINE void copyBlock(const BasicSegment<T>* segments, std::size_t first, std::size_t last,
                               BasicClipped<BasicSegment<T>>* out, bool streamed)
{
    for (std::size_t i = first; i < last; ++i, ++out)
        if (streamed)
            stream(out, segments[i], i);
        else
            *out = {segments[i], static_cast<std::uint32_t>(i), 0};
}

template <class V, class First, class Shape>
CLIPPING_INLINE BatchResult clipInVectors(const Shape& shape)
{
    const auto& batch = shape.batch;
    std::uint32_t indices[blockSize + V::width + First::width];
    const bool streamed = isStreamed(batch.out, batch.end - batch.begin);
    BatchResult result{};
    bool wasUntouched = false; // the block before
    for (std::size_t first = batch.begin; first < batch.end; first += blockSize) {
        const std::size_t last = batch.end - first < blockSize ? batch.end : first + blockSize;
        auto* const out = batch.out + result.pieces;
        bool isUntouched = wasUntouched && shape.template isUntouched<First>(first, last);
        std::size_t count = last - first;
        if (!isUntouched) {
            count = shape.template survivors<First>(first, last, indices);
            isUntouched = !wasUntouched && count == last - first
                          && shape.template isUntouched<First>(first, last);
        }
        wasUntouched = isUntouched;
        if (isUntouched) {
            copyBlock(batch.segments, first, last, out, streamed);
            result.pieces += count;
            continue;
        }
        if (!shape.byVectors()) {
            result.pieces += shape.oneByOne(indices, count, out);
            continue;
        }
        const BatchResult block = clipSurvivors<V>(shape, indices, count, batch.segments + last,
                                                   out, batch.end - batch.begin - result.pieces);
        result.pieces += block.pieces;
        result.unsettled += block.unsettled;
    }
    if (streamed)
        finishStreaming();
    return result;
}

/// The functions of a row of `instructionSets`.
template <class V, class First, class T>
CLIPPING_INLINE BatchResult clipAtWindow(const Batch<T>& batch)
{
    return canShow(batch.window) ? clipInVectors<V, First>(WindowShape<T>{batch}) : BatchResult{};
}
template <class V>
CLIPPING_INLINE BatchResult clipAtPolygon(const PolygonBatch& batch)
{
    return batch.table->size <= 8 ? clipInVectors<V, V>(PolygonShape<true>{batch})
                                  : clipInVectors<V, V>(PolygonShape<false>{batch});
}

} // namespace
} // namespace clipping
