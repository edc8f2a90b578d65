// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_block.h"
#include "app/document/object_ranges.h"
#include "app/scene/float_box.h"

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Segments of one style that follow each other. A chunk ends before the next one begins, or with
/// its block.
struct SceneChunk {
    FloatBox box;
    StyleIndex style;
    std::uint32_t first; ///< a segment of the block
};
static_assert(sizeof(SceneChunk) == 24);

/// The shown segments of some consecutive objects, ready to be clipped; never changed. Curves are
/// flattened; a single point is a segment without length. Hidden objects have no segments.
struct SceneBlock {
    static constexpr std::size_t mostSegments = 65'536;
    /// A chunk ends after `mostInChunk` segments, and where the pen is lifted if it has
    /// `fewInChunk`, lest its box reach from one stroke to the next. Strokes whose boxes cover each
    /// other anyway are one chunk.
    static constexpr std::size_t mostInChunk = 64, fewInChunk = 8;
    static constexpr std::size_t chunksInBox = 16;

    std::vector<clipping::Segment> segments{};
    std::vector<SceneChunk> chunks{};
    std::vector<FloatBox> boxes{}; ///< each around `chunksInBox` chunks, the last around fewer
    /// Where the segments of each object begin, and the end. Empty: each object has one segment.
    std::vector<std::uint32_t> firstOfObject{};
    /// Its first object is the last one of the block before, which had no room for all its
    /// segments.
    bool continues = false;

    std::size_t objects() const;
    std::size_t firstOf(std::size_t object) const; ///< objects(): the end
    std::size_t objectOf(std::size_t segment) const;
    std::size_t chunkOf(std::size_t segment) const;
    std::size_t endOfChunk(std::size_t chunk) const;
};

/// The blocks of some objects, at least one. `hidden`: which of them a container hides, numbered in
/// `objects`. `tolerance`, in user units, is that of `flatten`.
std::vector<Shared<SceneBlock>>
sceneBlocksOf(const ObjectBlock& objects, std::span<const ObjectRange> hidden, double tolerance);

} // namespace app
