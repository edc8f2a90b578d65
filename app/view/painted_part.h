// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"
#include "clipping/geometry.h"

#include <span>
#include <vector>

namespace app {

/// The part of the lines that is painted.
enum class Painted : std::uint8_t { All, Kept, Removed };

/// What is painted of the lines of a frame, by chunk: no lines, all lines, or pieces.
class PaintedPart {
public:
    using Pieces = std::span<const clipping::Clipped>;

    PaintedPart(const SceneFrame& frame, Painted which) : frame_(frame), which_(which) {}

    Painted which() const { return which_; }
    Remains remains(std::size_t block, std::size_t chunk) const;

    /// The pieces of a chunk with Remains::Pieces, in the order of the lines; `source` is numbered
    /// within the block. Valid until the next call.
    Pieces pieces(std::size_t block, std::size_t chunk);

    /// Whether all lines [first, end) of a block are painted uncut.
    bool isWhole(std::size_t block, std::size_t first, std::size_t end) const;

    /// An estimate of the number of pieces; rarely exceeded.
    std::size_t expectedPieces() const;

private:
    // The painted part of the lines [first, end): `kept` itself, or the missing parts, which are
    // appended to `gaps`.
    Pieces painted(const SceneBlock& block, std::size_t first, std::size_t end, Pieces kept,
                   std::vector<clipping::Clipped>& gaps) const;

    SceneFrame frame_;
    Painted which_;
    std::vector<clipping::Clipped> gaps_;
};

/// Appends the missing parts of a line, in order. `kept` are the parts that are present, in order;
/// `source` is stored in every gap. A gap begins and ends bit for bit where kept pieces do. For a
/// single piece the rules are those of `clipping::outsideAll`: a single point of a longer line is
/// no gap, and a piece in reverse direction (from a published form) is turned round.
void appendGaps(const clipping::Segment& line, std::uint32_t source,
                std::span<const clipping::Clipped> kept, std::vector<clipping::Clipped>& gaps);

} // namespace app
