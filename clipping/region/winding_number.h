// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

namespace clipping {

/// The row `winding-number` for regions: the contract and the results of `clipAll` and `clip` in
/// region.h, bit for bit, by testing every edge for every segment.
RegionProgress windingClipAll(std::span<const Segment> in, const PreparedRegion& region,
                              std::span<RegionPiece> out, RegionProgress from = {});
std::vector<RegionPiece> windingClip(const Segment& segment, const PreparedRegion& region);

} // namespace clipping
