// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/runs.h"

#include <optional>

namespace app {

/// The edge of a window of any shape that cuts a line at this point. Empty if there is none, or if
/// the region is one axis-aligned rectangle.
std::optional<clipping::Segment> borderAt(const ClipRegion& region, const clipping::Segment& line,
                                          const Point& cut);

/// How far the corners of a stroke, which ends at right angles, are from the edge that cuts it: 0
/// at right angles, and along the edge. Both directions have any length.
double gapAtEdge(const Point& edge, const Point& line, double width);

/// The larger one of both ends of a part of a line.
double gapAtEnds(const clipping::Segment& line, const KeptPart& part, double width,
                 const ClipRegion& region);

} // namespace app
