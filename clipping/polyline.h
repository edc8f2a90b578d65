// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace CLEARCUT_API clipping {

/// A part of a polyline that is visible without a gap.
struct VisibleRun {
    std::size_t first;    ///< index of its first point in PolylineRuns::points
    std::size_t count;    ///< number of its points, at least 1
    std::uint32_t source; ///< segment where it begins, from point `source` to the next
    Edge begin;           ///< edge that cut it; NoEdge: an end, or next to a non-finite point
    Edge end;             ///< the same at its end
};

/// The visible part of a polyline. Reuse one object for many calls to reuse its memory.
template <class T>
struct CLEARCUT_HOLDS_CONTAINERS BasicPolylineRuns {
    std::vector<glm::vec<2, T>> points; ///< the points of all runs, one run after the other
    std::vector<VisibleRun> runs;       ///< in the order of the polyline
};
using PolylineRuns = BasicPolylineRuns<double>;

/// Computes the part of the polyline through `points` inside the closed window, bit for bit as the
/// row `exact` clips its segments: no wrong decision, new ends rounded once and exactly on the
/// window's edges. Replaces the content of `out`, in the order of the polyline; allocates only if
/// `out` has to grow. `points` must not lie in `out`. At most 2^32 - 1 points.
///
/// A run continues through every point of the polyline that is in the closed window; such points
/// are returned bit for bit and as often as they occur, so a polyline that is wholly inside gives
/// one run of all its points. Where the polyline only touches the window, at one of its points or
/// with a segment at a corner, there is a run of that one point, cut at both ends. A run that
/// reaches an edge from outside, follows it and leaves again is an ordinary run. A polyline of one
/// point is visible if the point is in the window. A segment with a non-finite number is not
/// visible; nothing is visible if min > max.
void clipPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out);

/// The same for a closed polyline, which continues from its last point to its first. A run through
/// the start is one run: the output begins after the first point that is outside or not finite. If
/// there is no such point, the output is one run, from the first point round to the first point
/// again.
void clipClosedPolyline(std::span<const glm::dvec2> points, const Window& window,
                        PolylineRuns& out);

} // namespace clipping
