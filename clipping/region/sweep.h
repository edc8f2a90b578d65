// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/edges_near.h"
#include "clipping/region/line_walk.h"

namespace clipping {

/// Finds the kept pieces of segments that may meet edges, with a grid of the region: only the edges
/// in the cells along the segment are tested, and the winding numbers at its start are counted from
/// the reference point of its cell.
class LineSweep {
public:
    explicit LineSweep(const PreparedRegion::Data& region)
        : region_(region), edges_(region), walk_(region)
    {
    }

    /// The kept pieces of a finite segment whose bounding box meets that of the region. Valid until
    /// the next call.
    std::span<const RegionPiece> piecesOf(const Segment& segment, std::uint32_t source,
                                          const RegionGrid& grid);
    std::span<const RegionPiece> piecesOf(const Segment& segment, std::uint32_t source)
    {
        return piecesOf(segment, source, region_.grid);
    }

private:
    void findMeetings(const SweptLine& swept, const RegionGrid& grid);
    std::size_t addNear(const DirectedLine& line, std::span<const std::uint32_t> edges,
                        std::size_t count);
    void enterAt(const SweptLine& swept, const RegionGrid& grid);

    const PreparedRegion::Data& region_;
    EdgesNear edges_;
    LineWalk walk_;
    Meetings meetings_;
    std::vector<std::uint32_t> near_; ///< edges that the line may meet
    bool isNearEdge_ = false;         ///< whether the segment may
};

} // namespace clipping
