// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

/// What the rows of the catalogue do against convex polygons, for their `polygon`.
extern const Uses<Segment, ConvexPolygon> cyrusBeckPolygon;
extern const Uses<Segment, ConvexPolygon> skalaPolygon, skalaSearchedPolygon;

} // namespace clipping
