// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/scene/scene_block.h"

namespace app {

/// The result of clipping the lines of a scene. Valid until the next call of the function that made
/// it, and until the scene's lines change.
struct SceneFrame {
    struct Block {
        const SceneBlock* block;
        std::size_t firstObject, firstLine;
        std::span<const Remains> remains; ///< for each chunk of the block
        /// The kept pieces of the chunks with Remains::Pieces, in the order of the lines. `source`
        /// is numbered within the block.
        std::span<const clipping::Clipped> pieces;
    };
    std::span<const Block> blocks{};
    std::size_t total = 0;         ///< number of lines
    std::size_t visible = 0;       ///< lines of which at least a part is kept
    std::uint64_t nanoseconds = 0; ///< processor time of the clipping alone
};

} // namespace app
