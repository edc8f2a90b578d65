// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "clipping/region/region.h"

namespace app {

/// The clip windows as the library's region: at it areas are cut, and lines with exact decisions.
/// The one that the region has already, or a new one.
std::shared_ptr<const clipping::PreparedRegion> areaWindows(const ClipRegion& region);

} // namespace app
