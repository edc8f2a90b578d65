// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace clipping {

/// Bounding boxes of short runs of segments, for drawings that stay while the window moves. Clips
/// as the row `exact` does, bit for bit, but looks only at the segments near the window's edges:
/// in drawings, neighbours in the array are mostly neighbours on the sheet. A run ends after
/// `longest` segments, and where the pen was lifted, lest a box reach from one stroke to the next.
template <class T>
class BasicChunks {
public:
    static constexpr std::size_t longest = 64; ///< segments in a run
    static constexpr std::size_t shortest = 8; ///< before a run ends where the pen was lifted

    BasicChunks() = default;
    /// The boxes of these segments, in a time proportional to their number.
    explicit BasicChunks(std::span<const BasicSegment<T>> segments);

    /// The segments from `first` to `last` (not included) are new. If there are as many as before,
    /// the others have not changed; if not, all from `first` on may have.
    void update(std::span<const BasicSegment<T>> segments, std::size_t first, std::size_t last);

    /// `exact`'s clipAll on the segments that the boxes were made of: `out.size() >=
    /// segments.size()`, no overlap; keeps the order, returns how many were written, allocates
    /// nothing.
    std::size_t clipAll(std::span<const BasicSegment<T>> segments, const BasicWindow<T>& window,
                        std::span<BasicClipped<BasicSegment<T>>> out) const;

private:
    struct Chunk {
        BasicWindow<T> box;
        std::size_t end; ///< one behind its last segment; the next one begins here
    };
    std::vector<Chunk> chunks_;
};
using Chunks = BasicChunks<double>;

} // namespace clipping
