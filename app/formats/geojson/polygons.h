// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <vector>

namespace app::geojson {

using Ring = std::vector<Point>; ///< closed: its last point is its first one

/// An outer ring, then its holes.
using Polygon = std::vector<Ring>;

/// The polygons of rings that do not cross each other: what an even number of others surrounds is
/// an outer ring, counterclockwise if y points up; the rest are holes. Rings without area are left
/// out.
std::vector<Polygon> polygonsOf(std::vector<Ring> rings);

} // namespace app::geojson
