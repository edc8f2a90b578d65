// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region_clipping.h"
#include "app/scene/scene_frame.h"
#include "app/scene/scene_lines.h"

namespace app {

/// Clips the lines of a scene for each frame. Reuses its buffers.
class SceneClipping {
public:
    /// Clips all lines. The algorithm `exact` first tests boxes and then clips only the lines near
    /// an edge; any other algorithm clips every line. The pieces have the same bits as those of a
    /// single call for all lines. An algorithm that cannot clip at one of the windows is replaced
    /// (`usedAt`). Without a window nothing is clipped. The frame is valid until the next call and
    /// as long as `lines`; it is of no use if a stop was requested.
    SceneFrame clip(const SceneLines& lines, const ClipRegion& region, ClipAll clipAll,
                    const std::stop_token& stop = {});

private:
    using Block = SceneFrame::Block;

    void makeBlocks(const SceneLines& lines);
    void clipNearEdges(Block& frame, std::span<Remains> remains, const clipping::Window& window);
    void clipInRegion(Block& frame, std::span<Remains> remains);
    std::span<clipping::Clipped> clipAtOneWindow(const SceneBlock& block,
                                                 std::span<const Remains> remains);
    void settle(Block& frame, std::span<Remains> remains, std::span<clipping::Clipped> room);

    const ClipRegion* region_ = nullptr;
    RegionClipping regionClipping_;
    Stopwatch stopwatch_; ///< all work that regionClipping_ does not time
    std::vector<Block> blocks_;
    std::vector<Remains> remains_;
    std::vector<clipping::Clipped> folded_; ///< pieces of one block
    std::vector<clipping::Segment> near_;   ///< lines of one block near the border
    std::vector<std::uint32_t> sources_;    ///< their numbers
    PieceStore pieces_;
    std::size_t visible_ = 0;
};

} // namespace app
