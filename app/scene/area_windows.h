// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "clipping/region/region.h"

namespace app {

/// The clip windows as a region at which areas are cut. A region of axis-aligned rectangles alone
/// is not prepared for lines, which every algorithm can clip there.
std::shared_ptr<const clipping::PreparedRegion> areaWindows(const ClipRegion& region);

} // namespace app
