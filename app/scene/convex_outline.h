// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "clipping/geometry.h"

#include <vector>

namespace app {

/// The rings of a window's border as a convex polygon, decided exactly. Without corners if there
/// are several rings, or if the ring is not convex, goes round more than once or has no area.
clipping::ConvexPolygon convexPolygonOf(const std::vector<std::vector<Point>>& rings);

} // namespace app
