// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"

namespace app {

/// For each step, the piece of one line that an algorithm has left, if any.
using PiecesOfLine = std::span<const std::optional<clipping::Clipped>>;

/// Whether a piece exists and its numbers are finite.
bool isSeen(const std::optional<clipping::Clipped>& piece);

/// Does the work of `fold` for one line by dividing it at the ends of all pieces. O(windows · log
/// windows).
void foldDivided(const ClipRegion& region, const clipping::Segment& line, std::uint32_t source,
                 PiecesOfLine atStep, std::vector<clipping::Clipped>& kept);

} // namespace app
