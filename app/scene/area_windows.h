// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"
#include "app/document/path.h"
#include "app/scene/region.h"
#include "clipping/geometry.h"
#include "clipping/region/region.h"

#include <span>
#include <vector>

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

/// The union of the shapes of several windows, whatever their operations, as one path of straight
/// lines: curves are replaced within 0.01 mm on paper. Decided exactly (clipping/area).
PathShape united(std::span<const ClipWindow> windows, const Page& page);

/// The rings of a window's border as a convex polygon, decided exactly. Without corners if there
/// are several rings, or if the ring is not convex, goes round more than once or has no area.
clipping::ConvexPolygon convexPolygonOf(const std::vector<std::vector<Point>>& rings);

} // namespace app
