// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/piece_store.h"
#include "app/scene/region_clipping.h"
#include "app/scene/scene_frame.h"
#include "app/scene/scene_lines.h"

namespace app {

/// Clips the lines of a scene, frame by frame. Keeps its buffers.
class SceneClipping {
public:
    /// What is kept of all lines. The row `exact` looks at boxes first, and at the lines near an
    /// edge only; any other algorithm clips every line. The pieces have the same bits as those of
    /// one call for all lines. Without a window nothing is clipped. Valid until the next call, and
    /// as long as `lines`.
    SceneFrame clip(const SceneLines& lines, const ClipRegion& region, ClipAll clipAll);

private:
    using Block = SceneFrame::Block;

    void makeBlocks(const SceneLines& lines);
    void clipNearEdges(Block& frame, std::span<Remains> remains, const clipping::Window& window);
    void clipInRegion(Block& frame, std::span<Remains> remains);
    void settle(Block& frame, std::span<Remains> remains, std::span<clipping::Clipped> room);

    const ClipRegion* region_ = nullptr;
    ClipAll clipAll_ = nullptr;
    RegionClipping regionClipping_;
    Stopwatch stopwatch_; ///< of all that regionClipping_ does not time
    std::vector<Block> blocks_;
    std::vector<Remains> remains_;
    std::vector<clipping::Clipped> folded_; ///< of one block
    PieceStore pieces_;
    std::size_t visible_ = 0;
};

} // namespace app
