// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

// Clips segments at areas of any shape: concave, with holes, crossing themselves; several of them
// together, added, cut out and intersected. All decisions are exact.

namespace CLEARCUT_API clipping {

/// Which winding numbers are inside: all but 0, or the odd ones.
enum class FillRule : std::uint8_t { NonZero, EvenOdd };

/// A set of points bounded by closed rings of straight edges. It is the closure of the points off
/// the edges whose winding number satisfies the rule. So it contains its border; an edge with
/// inside on neither side is not part of it, and rings without area (repeated points, a line there
/// and back) contribute nothing. Rings may cross and touch themselves and each other. An area with
/// a number that is not finite contains nothing.
struct CLEARCUT_HOLDS_CONTAINERS Area {
    std::vector<glm::dvec2> points; ///< ring after ring; the last point of a ring joins its first
    /// For each ring, one past the index of its last point, ascending. Empty: all points are one
    /// ring. Points after the last ring are ignored.
    std::vector<std::uint32_t> ringEnds{};
    FillRule rule = FillRule::NonZero; ///< which winding numbers are inside
};

/// The area of a window: four edges (bottom, right, top, left if y points up). Contains nothing if
/// `min >= max` on an axis or a number is not finite: unlike a window, an area has no lines and
/// points without area.
Area areaOf(const Window& window);

/// What an area does to the points of the areas before it.
enum class AreaOperation : std::uint8_t { Add, CutOut, Intersect };

/// Whether the points in the set are kept, or those not in it.
enum class Keep : std::uint8_t { Inside, Outside };

/// A set of points. It starts with no point if the first step adds, else with all points; then each
/// step adds its area, cuts it out, or intersects with it. A cut-out removes the border of its area
/// too. Without steps everything is kept, whatever `keep` is.
struct CLEARCUT_HOLDS_CONTAINERS Region {
    /// One area, and what it does.
    struct Step {
        Area area;                                    ///< a set of points
        AreaOperation operation = AreaOperation::Add; ///< what happens to its points
    };
    std::vector<Step> steps;  ///< in their order
    Keep keep = Keep::Inside; ///< which points of the plane are kept in the end
};

/// A region with its edges in a search grid. Cheap to copy; may be used by several threads.
/// Preparing takes O(edges · log) in ordinary drawings. A region has less than 2^32 - 1 points.
class PreparedRegion {
public:
    explicit PreparedRegion(const Region& region); ///< makes the grid

    /// The edge with a number from a RegionPiece.
    struct Edge {
        std::uint32_t step; ///< index of the area's step
        Segment segment;    ///< in the ring's direction
    };
    Edge edge(std::uint32_t number) const; ///< the number is not 0

    struct Data;
    const Data& data() const { return *data_; } ///< for the library

private:
    std::shared_ptr<const Data> data_;
};

/// A kept piece of a segment. An edge number is 0 for an end of the input, otherwise 1 + the index
/// of the edge's first point among the points of all areas, in the order of the steps. Of several
/// edges that meet where the segment is cut, it is the first one of an area that the segment enters
/// or leaves there.
struct RegionPiece {
    Segment segment;       ///< the piece, from the input's a to its b
    std::uint32_t source;  ///< index in the input (a call takes fewer than 2^32 segments)
    std::uint32_t edgeOfA; ///< the edge that cut it at its a
    std::uint32_t edgeOfB; ///< the edge that cut it at its b
};

/// How far `clipAll` got.
struct RegionProgress {
    std::size_t segment = 0; ///< index of the next segment; the number of segments: all are done
    std::size_t piece = 0;   ///< number of pieces of that segment that are already written
    std::size_t written = 0; ///< number of pieces that the call wrote
};

/// Clips segments at a region and writes the kept pieces in input order, the pieces of a segment in
/// its direction. Stops when `out` is full, also in the middle of a segment; call it again with the
/// returned progress to continue. The result does not depend on the size of `out`, but a segment
/// that is interrupted is clipped again from its start.
///
/// The kept part is the closure, within the segment, of its points that the region keeps:
/// 1. Where a segment enters and leaves each area, whether it touches it, and the order of these
///    places are decided exactly, for all finite numbers. Pieces on both sides of an edge that two
///    added areas share are one piece. Along an edge, a segment is in an area that is filled on
///    either side. A cut-out met in a single point removes nothing; a single point that is kept
///    while its neighbours are not is a piece of length 0.
/// 2. An end of the segment that is kept is returned bit for bit. Every other end is the exact
///    point with each coordinate rounded once to the nearest double (never -0), so it is off by at
///    most half an ulp of that coordinate, lies on a horizontal or vertical edge bit for bit, and
///    consecutive ends along the segment never change their order.
/// 3. The reversed segment gives the reversed pieces, bit for bit.
///
/// For one window with area the result is that of the row `exact`, or of `outsideAll`; that joins
/// two pieces if the part between them rounds to a point. A segment with a number that is not
/// finite is in no area: it is kept or removed as a whole.
RegionProgress clipAll(std::span<const Segment> in, const PreparedRegion& region,
                       std::span<RegionPiece> out, RegionProgress from = {});

/// The kept pieces of one segment; `source` is 0.
std::vector<RegionPiece> clip(const Segment& segment, const PreparedRegion& region);

} // namespace clipping
