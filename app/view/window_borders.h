// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/draw_list.h"
#include "app/view/picture_options.h"

namespace app {

/// Whether the border of a window is so long that painting it takes many milliseconds. It is a part
/// of the picture then, which other threads paint.
bool isLong(const ClipRegion::Step& step);

/// The draw list for `options.borders`, of the region's steps.
DrawList windowBorders(const PictureOptions& options);

} // namespace app
