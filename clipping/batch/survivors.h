// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/lanes.h"
#include "clipping/batch/polygon_table.h"
#include "clipping/batch/sets.h"

// The first pass of the vector kernel over a block of segments.

namespace clipping {
namespace {

/// Twice how far a window reaches across the direction (dx, dy), times its length, with the margins
/// of missFactor. A window is symmetric to both axes.
template <class V>
struct WindowReach {
    V width, height, tiny;
    template <class T>
    CLIPPING_INLINE explicit WindowReach(const Box<T>& box)
        : width(V::of(box.width)), height(V::of(box.height)), tiny(V::of(missTiny<T>))
    {
    }
    CLIPPING_INLINE V across(V, V, V sizeX, V sizeY) const
    {
        return fma(width, sizeY, fma(height, sizeX, tiny));
    }
};

/// The same for a parallelogram with the half sides u and v around the box's centre. Its own
/// rounding errors are far below the 2^-40 by which it is larger than the polygon.
template <class V>
struct TurnedReach {
    V ux, uy, vx, vy, marginX, marginY, tiny;
    CLIPPING_INLINE explicit TurnedReach(const PolygonTable& t)
        : ux(V::of(2 * t.ux)), uy(V::of(2 * t.uy)), vx(V::of(2 * t.vx)), vy(V::of(2 * t.vy)),
          marginX(V::of(missFactor<double> * (t.acrossX + t.box.width))),
          marginY(V::of(missFactor<double> * (t.acrossY + t.box.height))),
          tiny(V::of(missTiny<double>))
    {
    }
    CLIPPING_INLINE V across(V dx, V dy, V sizeX, V sizeY) const
    {
        return abs(fnma(uy, dx, ux * dy)) + abs(fnma(vy, dx, vx * dy))
               + fma(marginX, sizeY, fma(marginY, sizeX, tiny));
    }
};

/// Prefetches what will be read after a vector of segments, 2 KiB on.
template <std::size_t width, class S>
CLIPPING_INLINE void prefetchAhead(const S* segments)
{
    constexpr std::size_t ahead = 2048, row = width * sizeof(S); // bytes
    // An integer, because the address may be behind the array.
    for (std::size_t line = 0; line < row; line += 64)
        __builtin_prefetch(reinterpret_cast<const void*>( // NOLINT(performance-no-int-to-ptr)
            reinterpret_cast<std::uintptr_t>(segments) + ahead + line));
}

/// Writes the indices of the segments that may be visible and returns their number: all but those
/// that sets.h proves to miss the box, or the shape in it. The output must have room for one vector
/// more than the block.
template <class V, class T, class Reach>
// NOLINTNEXTLINE(readability-function-size): input, shape and output
CLIPPING_INLINE std::size_t survivorsOf(const BasicSegment<T>* segments, std::size_t first,
                                        std::size_t last, const Box<T>& box, const Reach& shape,
                                        std::uint32_t* indices)
{
    const V twiceX = V::of(box.twiceX), twiceY = V::of(box.twiceY);
    const V width = V::of(box.width), height = V::of(box.height);
    const V factor = V::of(missFactor<T>), longer = V::of(missLength<T>);
    std::size_t count = 0, i = first;
    for (; i + V::width <= last; i += V::width) {
        prefetchAhead<V::width>(segments + i);
        const Ends<V> s = V::load(segments + i);
        const V dx = s.bx - s.ax, dy = s.by - s.ay;
        const V mx = (s.ax + s.bx) - twiceX, my = (s.ay + s.by) - twiceY;
        const V sizeX = abs(dx), sizeY = abs(dy);
        const V p = mx * dy, across = shape.across(dx, dy, sizeX, sizeY);
        const auto meets = notAbove(fnma(sizeX, longer, abs(mx)), width)
                           & notAbove(fnma(sizeY, longer, abs(my)), height)
                           & notAbove(abs(fnma(my, dx, p)), fma(abs(p), factor, across));
        count += V::storeIndices(indices + count, i, meets);
    }
    for (; i < last; ++i)
        indices[count++] = static_cast<std::uint32_t>(i);
    return count;
}

/// Whether the block consists of whole vectors of segments that are all inside the window. Worth
/// testing if all have survived, or first if the block before was like that, because in drawings
/// neighbours in the array are usually neighbours on the sheet.
template <class V, class T>
CLIPPING_INLINE bool untouched(const BasicSegment<T>* segments, std::size_t first, std::size_t last,
                               const BasicWindow<T>& window)
{
    const auto w = inEveryLane<V>(window);
    for (std::size_t i = first; i < last; i += V::width) {
        if (i + V::width > last)
            return false;
        prefetchAhead<V::width>(segments + i);
        const Ends<V> s = V::load(segments + i);
        // With a NaN, min and max return their second argument, so a segment with a NaN is never
        // inside.
        const auto inside = (min(s.ax, s.bx) >= w.minX) & (max(s.bx, s.ax) <= w.maxX)
                            & (min(s.ay, s.by) >= w.minY) & (max(s.by, s.ay) <= w.maxY);
        if (any(~inside))
            return false;
    }
    return true;
}

} // namespace
} // namespace clipping
