// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

/// The functions of catalogue rows for convex polygons.
extern const Functions<Segment, ConvexPolygon> cyrusBeckPolygon;
extern const Functions<Segment, ConvexPolygon> exactPolygon, exactSearchedPolygon;
extern const Functions<Segment, ConvexPolygon> skalaPolygon, skalaSearchedPolygon;
extern const Functions<Segment, ConvexPolygon> windingNumberPolygon;

} // namespace clipping
