// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/clip_lanes.h"
#include "clipping/batch/survivors.h"

// `exact` in vectors, written once for every instruction set (lanes.h says what the including file
// must observe). Block by block, it first rejects segments that cannot be visible, then clips the
// rest.
//
// The including file's `V` wraps its vectors of doubles, its `First` the vectors of T for the first
// pass.

namespace clipping {
namespace {

/// Handles the vectors of the second pass that are not settled at once, or that do not fit whole
/// into the remaining room. A separate function, to keep the common path small.
template <class V, class T>
[[gnu::noinline, gnu::cold]] BatchResult
clipWithCare(const Batch<T>& batch, const std::uint32_t* indices, std::size_t lanes,
             BasicClipped<BasicSegment<T>>* out, std::size_t room)
{
    const unsigned used = (1u << lanes) - 1;
    const auto clip =
        clipLanes<mostCare<T>>(V::gather(batch.segments, indices), inEveryLane<V>(batch.window));
    const unsigned unsettled = bits(clip.unsettled) & used, visible = bits(clip.visible) & used;
    if (unsettled == 0 && V::width <= room) {
        V::store(out, clip, indices, visible);
        return {static_cast<std::size_t>(__builtin_popcount(visible)), 0};
    }
    return {clipOneByOne(batch.segments, indices, lanes, batch.window, out),
            static_cast<std::size_t>(__builtin_popcount(unsettled))};
}

/// Second pass: clips the segments at `indices`, which has room to be padded to whole vectors, into
/// `out`, which has room for `room` pieces. Meanwhile prefetches what the next block will read.
template <class V, class T>
// NOLINTNEXTLINE(readability-function-size): needs input, output and the next block
CLIPPING_INLINE BatchResult clipSurvivors(const Batch<T>& batch, std::uint32_t* indices,
                                          std::size_t count, const BasicSegment<T>* next,
                                          BasicClipped<BasicSegment<T>>* out, std::size_t room)
{
    const auto w = inEveryLane<V>(batch.window);
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
        const auto clip = clipLanes<usualCare<T>>(V::gather(batch.segments, indices + i), w);
        if ((bits(clip.unsettled) & used) != 0 || result.pieces + V::width > room) {
            const auto careful = clipWithCare<V>(batch, indices + i, lanes, out + result.pieces,
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
                               BasicClipped<BasicSegment<T>>* out)
{
    for (std::size_t i = first; i < last; ++i)
        *out++ = {segments[i], static_cast<std::uint32_t>(i), 0};
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
        auto* const out = batch.out + result.pieces;
        if (count == last - first && untouched<First>(batch.segments, first, last, batch.window)) {
            copyBlock(batch.segments, first, last, out);
            result.pieces += count;
            continue;
        }
        const BatchResult block = clipSurvivors<V>(batch, indices, count, batch.segments + last,
                                                   out, batch.end - batch.begin - result.pieces);
        result.pieces += block.pieces;
        result.unsettled += block.unsettled;
    }
    return result;
}

} // namespace
} // namespace clipping
