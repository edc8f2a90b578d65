// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/line_or_ray.h"
#include "clipping/polygon/meet.h"

namespace clipping {

/// The part of the line or ray through two points inside a convex polygon. All decisions are exact,
/// and so is each new end, rounded once: half an ulp of the coordinate itself, for all finite
/// numbers. Nothing if the points are equal or not finite.
template <Reach reach>
std::optional<PolygonPiece<double>> lineOrRayInPolygon(const Segment& through,
                                                       const PreparedPolygon& polygon);

} // namespace clipping
