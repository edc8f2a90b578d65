// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/region.h"
#include "app/document/scene_block.h"

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

/// Calls visit(Clipped) for all that is kept in a block, in the order of the lines. `source` counts
/// in the block.
template <class Visit>
void forEachKept(const SceneFrame::Block& frame, const Visit& visit)
{
    auto piece = frame.pieces.begin();
    for (std::size_t chunk = 0; chunk < frame.remains.size(); ++chunk) {
        const std::size_t end = frame.block->endOfChunk(chunk);
        if (frame.remains[chunk] == Remains::Whole)
            for (std::size_t i = frame.block->chunks[chunk].first; i < end; ++i)
                visit(clipping::Clipped{frame.block->segments[i], std::uint32_t(i), 0});
        for (; piece != frame.pieces.end() && piece->source < end; ++piece)
            visit(*piece);
    }
}

} // namespace app
