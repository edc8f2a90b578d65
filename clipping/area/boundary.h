// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/area/along_edge.h"
#include "clipping/area/clip_area.h"
#include "clipping/region/edges.h"

namespace clipping {

/// A part of an edge that has the result on its left and not on its right.
struct BoundaryPiece {
    glm::dvec2 from, to;  ///< rounded; never -0
    const AreaEdge* edge; ///< whose part it is
    bool isOfWindow;      ///< whether the edge is
    bool isReversed;      ///< whether it runs against the edge

    EdgeOrigin origin() const
    {
        return {edge->number, isOfWindow, shareAlong(edge->segment, from),
                shareAlong(edge->segment, to)};
    }

    /// Two points of the piece's line, in its direction.
    const glm::dvec2& behind() const { return isReversed ? edge->segment.b : edge->segment.a; }
    const glm::dvec2& ahead() const { return isReversed ? edge->segment.a : edge->segment.b; }
};

/// Joins pieces to rings. At every point as many pieces begin as end.
ClippedArea ringsOf(std::span<const BoundaryPiece> pieces, const std::stop_token& stop);

/// Whether a loop over very many items is to end. Reads the token only now and then.
inline bool isStopped(const std::stop_token& stop, std::size_t item)
{
    constexpr std::size_t now = 4096;
    return item % now == 0 && stop.stop_requested();
}

} // namespace clipping
