// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace clipping {

/// Bounding boxes of short runs of segments, for drawings that stay while the window moves. Clips
/// as the row `exact` does, bit for bit, but looks only at the segments near the window's edges:
/// in drawings, neighbours in the array are mostly neighbours on the sheet.
template <class T>
class BasicChunks {
public:
    /// Of how many segments a box is made.
    static constexpr std::size_t size = 64;

    BasicChunks() = default;
    explicit BasicChunks(std::span<const BasicSegment<T>> segments);

    /// The segments from `first` to `last` (not included) are new; the others have not changed,
    /// but may have become fewer or more after `last`, which then is the end.
    void update(std::span<const BasicSegment<T>> segments, std::size_t first, std::size_t last);

    /// `exact`'s clipAll on the segments that the boxes were made of.
    std::size_t clipAll(std::span<const BasicSegment<T>> segments, const BasicWindow<T>& window,
                        std::span<BasicClipped<BasicSegment<T>>> out) const;

private:
    std::vector<BasicWindow<T>> boxes_;
};
using Chunks = BasicChunks<double>;

} // namespace clipping
