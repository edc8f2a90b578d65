// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region_clipping.h"
#include "app/scene/scene_frame.h"

namespace app {

/// Clips the lines of blocks, one after another, for one frame. Reuses its buffers, which hold the
/// blocks' pieces until the next start.
class BlockClipping {
public:
    /// `region` must live until the next start; `clipAll` is that of the chosen form.
    void start(const ClipRegion& region, ClipAll clipAll, const std::stop_token& stop);
    void startAs(const BlockClipping& other); ///< the same; the region is prepared already
    /// Sets the frame's pieces, and what remains of each chunk.
    void clip(SceneFrame::Block& frame, std::span<Remains> remains);

    std::size_t visible() const { return visible_; } ///< lines, of all blocks since the start
    std::uint64_t nanoseconds() const                ///< of clipping them
    {
        return stopwatch_.nanoseconds() + regionClipping_.nanoseconds();
    }

private:
    void start(const ClipRegion& region);
    void clipNearEdges(SceneFrame::Block& frame, std::span<Remains> remains,
                       const clipping::Window& window);
    void clipInRegion(SceneFrame::Block& frame, std::span<Remains> remains);
    std::span<clipping::Clipped> clipAtOneWindow(const SceneBlock& block,
                                                 std::span<const Remains> remains);
    void settle(SceneFrame::Block& frame, std::span<Remains> remains,
                std::span<clipping::Clipped> room);

    const ClipRegion* region_ = nullptr;
    std::optional<clipping::Window> window_; ///< if the row is `exact`, and its inside is kept
    RegionClipping regionClipping_;
    Stopwatch stopwatch_;                   ///< all work that regionClipping_ does not time
    std::vector<clipping::Clipped> folded_; ///< pieces of one block
    std::vector<clipping::Segment> near_;   ///< lines of one block near the border
    std::vector<std::uint32_t> sources_;    ///< their numbers
    PieceStore pieces_;
    std::size_t visible_ = 0;
};

} // namespace app
