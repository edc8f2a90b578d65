// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace clipping {

/// A stretch of a polyline that is visible without a gap.
struct VisibleRun {
    std::size_t first;    ///< of its points in PolylineRuns::points
    std::size_t count;    ///< of its points; at least one
    std::uint32_t source; ///< the segment it begins on: from point `source` to the next
    Edge begin;           ///< where it was cut; None: an end, or beside what is not finite
    Edge end;             ///< the same at its end
};

/// What a window leaves of a polyline. Keep one and hand it over again: its memory is reused.
struct PolylineRuns {
    std::vector<glm::dvec2> points; ///< of all runs, one after the other
    std::vector<VisibleRun> runs;   ///< in the order of the polyline
};

/// The part of the polyline through `points` inside the closed window, as the row `exact` clips its
/// segments: no wrong decision, new ends rounded once and on the window, bit for bit. Replaces what
/// is in `out`, in the order of the polyline; allocates only where `out` has to grow, which is why
/// it is handed in. `points` must not lie in `out`.
///
/// A run goes on through every point of the polyline that is in the window, its edges included;
/// such points come back bit for bit and as often as they are there, so that what is wholly inside
/// is one run of all its points. Where the polyline only touches the window, in a point of its own
/// or with a segment at a corner, there is a run of that one point, cut at both ends; a run that
/// comes to an edge from outside, follows it and leaves again is a run like others. A polyline of
/// one point is visible or not. A segment with a number that is not finite is not visible, nor is
/// anything if min > max. Fewer than 2^32 points.
void clipPolyline(std::span<const glm::dvec2> points, const Window& window, PolylineRuns& out);

/// The same for a closed one, which goes on from its last point to its first. A run through the
/// start is one run: the first comes after the first point that is outside, or not finite. If
/// nothing is, everything is one run, from the first point to the first point again.
void clipClosedPolyline(std::span<const glm::dvec2> points, const Window& window,
                        PolylineRuns& out);

} // namespace clipping
