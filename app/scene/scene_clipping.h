// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/block_clipping.h"
#include "app/scene/scene_lines.h"

namespace app {

/// Clips the lines of a scene for each frame, on all threads. Reuses its buffers.
class SceneClipping {
public:
    /// Clips all lines. The algorithm `exact` first tests boxes and then clips only the lines near
    /// an edge, unless nearly every line has a box of its own; any other one clips every line. The
    /// pieces have the same bits as those of a single call for all lines. An algorithm that cannot
    /// clip at one of the windows is replaced
    /// (`usedAt`). Without a window nothing is clipped. Blocks are clipped on all painting
    /// threads that are free. The frame is valid until the next call and as long as
    /// `lines`; it is of no use if a stop was requested.
    SceneFrame clip(const SceneLines& lines, const ClipRegion& region, ClipAll clipAll,
                    const std::stop_token& stop = {});

private:
    void makeBlocks(const SceneLines& lines);
    std::span<Remains> remainsOf(std::size_t block);

    std::vector<SceneFrame::Block> blocks_;
    std::vector<Remains> remains_;
    std::vector<std::size_t> firstChunks_; ///< of each block, in remains_
    std::vector<BlockClipping> workers_;   ///< one for each thread
};

} // namespace app
