// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "app/scene/scene_block.h"

namespace app {

/// Classifies each chunk of a block by its box alone. Gone and Whole agree bit for bit with the
/// results of the algorithm `exact` for all lines of the chunk. `remains` has one element for each
/// chunk.
void findRemains(const SceneBlock& block, const ClipRegion& region, std::span<Remains> remains);

} // namespace app
