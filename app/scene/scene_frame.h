// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/scene/scene_block.h"

namespace app {

/// What clipping has left of the lines of a scene. Valid until the next call of what made it, and
/// until its lines change.
struct SceneFrame {
    struct Block {
        const SceneBlock* block;
        std::size_t firstObject, firstLine;
        std::span<const Remains> remains; ///< of each of its chunks
        /// What is kept of the chunks with Remains::Pieces, in the order of the lines. `source`
        /// counts in the block.
        std::span<const clipping::Clipped> pieces;
    };
    std::span<const Block> blocks{};
    std::size_t total = 0;         ///< lines
    std::size_t visible = 0;       ///< lines of which something is kept
    std::uint64_t nanoseconds = 0; ///< of the clipping, nothing else
};

} // namespace app
