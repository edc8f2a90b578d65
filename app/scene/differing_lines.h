// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_frame.h"

#include <compare>
#include <vector>

namespace app {

/// A line of a frame: its block, and its number in the block.
struct FrameLine {
    std::size_t block, line;
    friend auto operator<=>(const FrameLine&, const FrameLine&) = default;
};

/// The lines of which two frames of the same lines keep different parts, in order: another number
/// of pieces, or ends more than `tolerance` (user units, ≥ 0) apart on an axis, whatever the
/// pieces' directions. Pieces that are not longer than this count as none. If there are more than
/// `most`, some `most` + 1 of them. Compares on all painting threads
/// that are free.
std::vector<FrameLine> differingLines(const SceneFrame& a, const SceneFrame& b, double tolerance,
                                      std::size_t most);

} // namespace app
