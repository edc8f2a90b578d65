// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/scene/scene_block.h"

namespace app {

/// What the boxes alone say about each chunk of a block: Gone and Whole are what the row `exact`
/// makes of all its lines, bit for bit. `remains` has an element for each chunk.
void findRemains(const SceneBlock& block, const ClipRegion& region, std::span<Remains> remains);

} // namespace app
