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

/// Whether all points of an area are finite.
bool isFinite(const Area& area);

/// The bounding box of the edges; at least one.
Window boxOf(std::span<const AreaEdge> edges);

inline bool contains(const Window& box, const glm::dvec2& p)
{
    return p.x >= box.min.x && p.x <= box.max.x && p.y >= box.min.y && p.y <= box.max.y;
}

} // namespace clipping
