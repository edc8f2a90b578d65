// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

#include <string_view>

namespace CLEARCUT_API clipping {

/// The form of a catalogue row (algorithm.h) for regions of any shape. Its functions keep the
/// contract of `clipAll` in region.h, apart from the errors that `ulps` allows.
struct CLEARCUT_HOLDS_CONTAINERS RegionAlgorithm {
    std::string_view key;  ///< that of the row
    std::string_view idea; ///< one sentence
    double ulps;           ///< the largest error of a new end, in ulps of the coordinate
    /// The kept pieces of one segment.
    std::vector<RegionPiece> (*clip)(const Segment& segment, const PreparedRegion& region);
    /// The kept pieces of many segments.
    RegionProgress (*clipAll)(std::span<const Segment> in, const PreparedRegion& region,
                              std::span<RegionPiece> out, RegionProgress from);
};

/// The rows that have such a form, in the catalogue's order.
std::span<const RegionAlgorithm> regionAlgorithms();

/// The form of the row with that key, or null: the row cannot clip at regions.
const RegionAlgorithm* findRegionAlgorithm(std::string_view key);

} // namespace clipping
