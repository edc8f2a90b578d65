// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

namespace CLEARCUT_API clipping {

/// What a region keeps of the points of a box.
enum class BoxPart : std::uint8_t {
    None,     ///< no point
    Whole,    ///< every point
    Undecided ///< an edge of an area meets the box
};

/// The part of a closed box that a region keeps, for skipping many segments at once: if it is None
/// or Whole, `clipAll` keeps nothing or everything of each finite segment in the box, bit for bit.
/// Exact; a box whose border an edge touches is Undecided. The box must be finite, with
/// `min <= max`. Tests only the edges in the box's cells of the region's grid.
BoxPart partOf(const Window& box, const PreparedRegion& region);

} // namespace clipping
