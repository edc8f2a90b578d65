// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_block.h"
#include "app/document/object_ranges.h"
#include "app/scene/float_box.h"

#include <cstdint>
#include <span>
#include <vector>

namespace app {

/// Consecutive segments of one style. A chunk ends where the next one begins, or at the end of its
/// block.
struct SceneChunk {
    FloatBox box;
    StyleIndex style;
    std::uint32_t first; ///< index of its first segment in the block
};
static_assert(sizeof(SceneChunk) == 24);

/// The visible segments of some consecutive objects, ready for clipping; immutable. Curves are
/// flattened; a single point is a segment of length zero. Hidden objects have no segments.
struct SceneBlock {
    static constexpr std::size_t mostSegments = 65'536;
    /// A chunk ends after `mostInChunk` segments. It also ends where the pen is lifted after at
    /// least `fewInChunk` segments, so that its box does not span separate strokes. Strokes whose
    /// boxes largely overlap share a chunk.
    static constexpr std::size_t mostInChunk = 64, fewInChunk = 8;
    static constexpr std::size_t chunksInBox = 16;

    std::vector<clipping::Segment> segments{};
    std::vector<SceneChunk> chunks{};
    std::vector<FloatBox> boxes{}; ///< each around `chunksInBox` chunks; the last may have fewer
    /// The first segment of each object, then the number of segments. Empty: each object has
    /// exactly one segment.
    std::vector<std::uint32_t> firstOfObject{};
    /// Whether the first object continues the last object of the previous block, which had no room
    /// for all its segments.
    bool continues = false;

    std::size_t objects() const;
    std::size_t firstOf(std::size_t object) const; ///< for objects(): the number of segments
    std::size_t objectOf(std::size_t segment) const;
    std::size_t chunkOf(std::size_t segment) const;
    std::size_t endOfChunk(std::size_t chunk) const;
};

/// The scene blocks of some objects, at least one block. `hidden`: the objects hidden by a
/// container, numbered within `objects`. `tolerance` is the flattening tolerance in user units.
std::vector<Shared<SceneBlock>>
sceneBlocksOf(const ObjectBlock& objects, std::span<const ObjectRange> hidden, double tolerance);

} // namespace app
