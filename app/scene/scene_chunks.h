// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_block.h"

namespace app {

/// Creates the chunks and boxes of a block that has its segments. `styles` has one style for all
/// objects, or one for each.
void makeChunks(SceneBlock& block, std::span<const StyleIndex> styles);

} // namespace app
