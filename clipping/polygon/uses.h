// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

/// The functions of catalogue rows for convex polygons.
extern const Uses<Segment, ConvexPolygon> cyrusBeckPolygon;
extern const Uses<Segment, ConvexPolygon> exactPolygon, exactSearchedPolygon;
extern const Uses<Segment, ConvexPolygon> skalaPolygon, skalaSearchedPolygon;
extern const Uses<Segment, ConvexPolygon> windingNumberPolygon;

} // namespace clipping
