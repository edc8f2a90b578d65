// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

namespace clipping {

/// The point at which a segment crosses an edge, each coordinate rounded once to the nearest
/// double, ties to even; never -0. The ends of each must be strictly on both sides of the other.
/// As rounding is monotone, the result is in the bounding boxes of both, and on the edge (or the
/// segment) bit for bit if that is horizontal or vertical.
glm::dvec2 meetingPoint(const Segment& s, const Segment& edge);

} // namespace clipping
