// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/batch/lanes.h"
#include "clipping/batch/polygon_table.h"
#include "clipping/batch/sets.h"

// The first pass of the vector kernel over a block of segments.

namespace clipping {
namespace {

/// How far a shape around the centre reaches across the direction (dx, dy), times its length; and a
/// sum of magnitudes that bounds its error (missBound). A window is symmetric to both axes.
template <class V>
struct WindowReach {
    V halfWidth, halfHeight;
    template <class T>
    CLIPPING_INLINE explicit WindowReach(const Box<T>& box)
        : halfWidth(V::of(box.halfWidth)), halfHeight(V::of(box.halfHeight))
    {
    }
    struct Extent {
        V reach, size;
    };
    CLIPPING_INLINE Extent of(V dx, V dy) const
    {
        const V reach = fma(halfWidth, abs(dy), halfHeight * abs(dx));
        return {reach, reach};
    }
};

/// The same for a parallelogram with the half sides u and v.
template <class V>
struct TurnedReach {
    V ux, uy, vx, vy, halfWidth, halfHeight;
    CLIPPING_INLINE explicit TurnedReach(const PolygonTable& t)
        : ux(V::of(t.ux)), uy(V::of(t.uy)), vx(V::of(t.vx)), vy(V::of(t.vy)),
          halfWidth(V::of(t.acrossX)), halfHeight(V::of(t.acrossY))
    {
    }
    struct Extent {
        V reach, size;
    };
    CLIPPING_INLINE Extent of(V dx, V dy) const
    {
        return {abs(fnma(uy, dx, ux * dy)) + abs(fnma(vy, dx, vx * dy)),
                fma(halfWidth, abs(dy), halfHeight * abs(dx))};
    }
};

/// Writes the indices of the segments that may be visible and returns their number. The output must
/// have room for one vector more than the block.
template <class V, class T, class Reach>
// NOLINTNEXTLINE(readability-function-size): input, shape and output
CLIPPING_INLINE std::size_t survivorsOf(const BasicSegment<T>* segments, std::size_t first,
                                        std::size_t last, const Box<T>& box, const Reach& shape,
                                        std::uint32_t* indices)
{
    constexpr std::size_t ahead = 2048, row = V::width * sizeof(BasicSegment<T>); // bytes
    const auto w = inEveryLane<V>(box.window);
    const V centreX = V::of(box.centreX), centreY = V::of(box.centreY);
    const V relative = V::of(missBound<T>), absolute = V::of(missTiny<T>);
    std::size_t count = 0, i = first;
    for (; i + V::width <= last; i += V::width) {
        // An integer, because the address may be behind the array.
        for (std::size_t line = 0; line < row; line += 64)
            __builtin_prefetch(reinterpret_cast<const void*>( // NOLINT(performance-no-int-to-ptr)
                reinterpret_cast<std::uintptr_t>(segments + i) + ahead + line));
        const Ends<V> s = V::load(segments + i);
        const auto beyond = (max(s.ax, s.bx) < w.minX) | (min(s.ax, s.bx) > w.maxX)
                            | (max(s.ay, s.by) < w.minY) | (min(s.ay, s.by) > w.maxY);
        const V dx = s.bx - s.ax, dy = s.by - s.ay;
        const V p = (s.ax - centreX) * dy, q = (s.ay - centreY) * dx;
        const auto [reach, size] = shape.of(dx, dy);
        const V bound = fma(size + abs(p) + abs(q), relative, absolute);
        const auto misses = abs(p - q) > reach + bound;
        count += V::storeIndices(indices + count, i, ~(beyond | misses));
    }
    for (; i < last; ++i)
        indices[count++] = static_cast<std::uint32_t>(i);
    return count;
}

/// Whether the block consists of whole vectors of segments that are all inside the window. Worth
/// testing if all have survived, because in drawings neighbours in the array are usually neighbours
/// on the sheet.
template <class V, class T>
CLIPPING_INLINE bool untouched(const BasicSegment<T>* segments, std::size_t first, std::size_t last,
                               const BasicWindow<T>& window)
{
    const auto w = inEveryLane<V>(window);
    for (std::size_t i = first; i < last; i += V::width) {
        if (i + V::width > last)
            return false;
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
