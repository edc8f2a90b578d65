// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

namespace clipping {

/// An edge of an area: two different points.
struct AreaEdge {
    Segment segment;
    std::uint32_t step;   ///< of the region, whose area it bounds
    std::uint32_t number; ///< as in RegionPiece
};

/// The edges of all areas without non-finite numbers, ordered by number. Edges between equal points
/// are left out.
std::vector<AreaEdge> edgesOf(const Region& region);

/// The bounding box of the edges; at least one.
Window boxOf(std::span<const AreaEdge> edges);

} // namespace clipping
