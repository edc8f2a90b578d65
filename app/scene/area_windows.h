// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/region.h"
#include "clipping/region/region.h"

namespace app {

/// Whether the box is finite and not inverted, so that it contains at least one point.
bool isProper(const clipping::Window& box);

/// The area inside a window's border; it contains nothing if the window contains nothing.
clipping::Area areaOf(const ClipRegion::Step& step);

/// The clip windows as the library's region: at it areas are cut, and lines with exact decisions.
/// The one that the region has already, or a new one; it is prepared.
std::shared_ptr<const clipping::PreparedRegion> areaWindows(const ClipRegion& region);

/// The same with one side kept, whatever the region says; prepared when it is used.
std::shared_ptr<const LaterRegion> laterRegion(const ClipRegion& region, Keep keep);

} // namespace app
