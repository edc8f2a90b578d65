// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/polygon/edge_table.h"
#include "clipping/region/sweep.h"

#include <memory>

namespace clipping {

/// A region that is a single strictly convex area, kept inside: the vector kernel for convex
/// polygons clips at it several times as fast as the sweep.
struct ConvexRegion {
    ConvexRegion(std::vector<glm::dvec2> ccw, PreparedPolygon prepared, bool reversed)
        : corners(std::move(ccw)), polygon(std::move(prepared)), table(polygon),
          isReversed(reversed)
    {
    }
    std::vector<glm::dvec2> corners; ///< counter-clockwise
    PreparedPolygon polygon;
    EdgeTable table;
    bool isReversed; ///< whether the area's points are clockwise
};

/// Null for all other regions, and for numbers that the kernel cannot take.
std::unique_ptr<const ConvexRegion> convexRegion(const Region& region);

/// `clipAll` of region.h at such a region. `sweep` is for segments that are cut at a corner, where
/// the kernel names the edge by another rule.
RegionProgress clipAllConvex(std::span<const Segment> in, const ConvexRegion& region,
                             LineSweep& sweep, std::span<RegionPiece> out, RegionProgress from);

} // namespace clipping
