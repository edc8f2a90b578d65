// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

// Types that the parts of the vector kernel share. A file that includes this is compiled for
// instructions that the processor may lack. So everything here and in the parts is in an anonymous
// namespace and nothing from elsewhere is instantiated; otherwise the linker might keep a copy of
// an inline function that only some processors can run.

namespace clipping {
namespace {

#define CLIPPING_INLINE [[gnu::always_inline]] inline
#define LANE [[maybe_unused]] CLIPPING_INLINE friend

/// The four coordinates of as many segments as a vector has lanes.
template <class V>
struct Ends {
    V ax, ay, bx, by;
};

/// The window in every lane.
template <class V>
struct VectorWindow {
    V minX, minY, maxX, maxY;
};
template <class V, class T>
CLIPPING_INLINE VectorWindow<V> inEveryLane(const BasicWindow<T>& w)
{
    return {V::of(w.min.x), V::of(w.min.y), V::of(w.max.x), V::of(w.max.y)};
}

/// The result for a vector of segments.
template <class V>
struct Clip {
    Ends<V> piece;
    V cut; ///< as bits: BasicClipped::cut, in the upper half of each lane
    typename V::Mask visible, unsettled;
};

} // namespace
} // namespace clipping
