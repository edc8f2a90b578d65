// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"

namespace app {

/// What an algorithm has left of one line, for each step.
using PiecesOfLine = std::span<const std::optional<clipping::Clipped>>;

/// Whether an algorithm has left something of a line that is worth a look: finite numbers.
bool isSeen(const std::optional<clipping::Clipped>& piece);

/// `fold` for a line that is divided at the ends of all pieces. O(windows · log windows).
void foldDivided(const ClipRegion& region, const clipping::Segment& line, std::uint32_t source,
                 PiecesOfLine atStep, std::vector<clipping::Clipped>& kept);

} // namespace app
