// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/scene/scene_block.h"
#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

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

/// Stores the pieces of a frame in contiguous groups, which do not move until `clear`. The memory
/// is reused for the next frame: writing to a new memory page costs more time than clipping all
/// lines that fill it.
class PieceStore {
public:
    void clear();
    /// Space for a group of `count` pieces. Valid until the next call.
    std::span<clipping::Clipped> room(std::size_t count);
    /// Keeps the first `count` pieces of the last space that room() returned.
    std::span<const clipping::Clipped> keep(std::size_t count);

private:
    static constexpr std::size_t mostInPage = 65'536; ///< a larger group gets a larger page

    std::vector<std::vector<clipping::Clipped>> pages_;
    std::size_t page_ = 0;      ///< the current page, which has space left
    std::size_t used_ = 0;      ///< pieces used in it
    std::size_t mostPages_ = 0; ///< that were used since pages were freed
    int clears_ = 0;            ///< since then
};

} // namespace app
