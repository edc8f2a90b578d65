// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"

#include <vector>

namespace app {

/// Which part of the lines is painted.
enum class Painted : std::uint8_t { All, Kept, Removed };

/// What is painted of the lines of a frame, chunk by chunk: nothing, all lines, or some pieces.
class PaintedPart {
public:
    using Pieces = std::span<const clipping::Clipped>;

    PaintedPart(const SceneFrame& frame, Painted which) : frame_(frame), which_(which) {}

    Remains remains(std::size_t block, std::size_t chunk) const;

    /// Of a chunk with Remains::Pieces, in the order of the lines; `source` counts in the block.
    /// Valid until the next call. Blocks and chunks must ascend from call to call.
    Pieces pieces(std::size_t block, std::size_t chunk);

    /// Whether each of the lines [first, end) of a block is there, uncut.
    bool isWhole(std::size_t block, std::size_t first, std::size_t end) const;

    /// There are hardly more pieces than this.
    std::size_t expectedPieces() const;

private:
    // Of the lines [first, end): `kept` itself, or what is missing, which goes to `gaps`.
    Pieces painted(const SceneBlock& block, std::size_t first, std::size_t end, Pieces kept,
                   std::vector<clipping::Clipped>& gaps) const;

    SceneFrame frame_;
    Painted which_;
    std::size_t block_ = std::size_t(-1); // that next_ is in
    Pieces::iterator next_{};
    std::vector<clipping::Clipped> gaps_;
};

} // namespace app
