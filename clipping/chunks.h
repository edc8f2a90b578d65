// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace CLEARCUT_API clipping {

/// Bounding boxes of short runs of segments, for drawings that stay the same while the window
/// moves. Clips like the row `exact`, bit for bit, but examines only the segments near the window's
/// edges: in drawings, neighbours in the array are usually neighbours on the sheet. A run ends
/// after `longest` segments, or where the pen was lifted, so that no box spans from one stroke to
/// the next.
template <class T>
class CLEARCUT_HOLDS_CONTAINERS BasicChunks {
public:
    static constexpr std::size_t longest = 64; ///< maximum number of segments in a run
    static constexpr std::size_t shortest = 8; ///< minimum before a lifted pen ends a run

    BasicChunks() = default;
    /// Builds the boxes of these segments, in time proportional to their number.
    explicit BasicChunks(std::span<const BasicSegment<T>> segments);

    /// Updates the boxes after the segments from `first` up to, not including, `last` have changed.
    /// If the number of segments is the same as before, the others must not have changed; if not,
    /// all from `first` on may have changed.
    void update(std::span<const BasicSegment<T>> segments, std::size_t first, std::size_t last);

    /// Does what `exact`'s clipAll does, on the segments that the boxes were built from:
    /// `out.size() >= segments.size()`, no overlap; writes in input order, returns the number of
    /// pieces, allocates nothing.
    std::size_t clipAll(std::span<const BasicSegment<T>> segments, const BasicWindow<T>& window,
                        std::span<BasicClipped<BasicSegment<T>>> out) const noexcept;

private:
    struct Chunk {
        BasicWindow<T> box;
        std::size_t end; ///< one past its last segment, where the next chunk begins
    };
    std::vector<Chunk> chunks_;
};
using Chunks = BasicChunks<double>;

} // namespace clipping
