// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/region.h"

#include <stop_token>

// Clips filled areas at areas of any shape. All decisions are exact; only the coordinates of the
// result are rounded.
//
// The method, as in Martinez, Rueda and Feito, "A new algorithm for computing Boolean operations on
// polygons" (Computers & Geosciences 35, 2009): divide the edges of both areas where they meet,
// keep each part that has the result on one side only, and join the parts to rings. Instead of
// special cases for what Foster, Hormann and Popa call degeneracies ("Clipping simple polygons with
// degenerate intersections", Computers & Graphics: X 2, 2019), winding numbers are counted on both
// sides of an edge, infinitely near to it (region/sweep.h).

namespace CLEARCUT_API clipping {

/// What a window leaves of an area.
enum class AreaPart : std::uint8_t {
    None,    ///< nothing with area
    Whole,   ///< the area, unchanged: the rings are left empty, use the input
    Cut,     ///< the rings of the result
    Refused, ///< a number is not finite, or area and window both reach to infinity
    Stopped  ///< nothing is known, because a stop was requested
};

/// Where an edge of the result comes from: from an edge of the area or of the window, `from` and
/// `to` of the way along it. `from > to` if the result runs against that edge.
///
/// 0 and 1 are its ends, exactly. Any other share is that of the rounded point on the edge's longer
/// axis, within 2^-52 of itself: off by less than two ulps of the point, divided by the edge's
/// extent. Shares along an edge never change their order.
struct EdgeOrigin {
    std::uint32_t number; ///< of the edge, as in RegionPiece: PreparedRegion::edge finds it
    bool isOfWindow;      ///< whether the number counts the points of the window's areas
    double from;          ///< share of the way along the edge where it begins
    double to;            ///< share where it ends
};

/// The part of an area that a window keeps.
struct CLEARCUT_HOLDS_CONTAINERS ClippedArea {
    AreaPart part = AreaPart::None; ///< nothing, all, or some of it
    /// Ring after ring; the last point of a ring joins its first.
    std::vector<glm::dvec2> points{};
    std::vector<std::uint32_t> ringEnds{}; ///< as in Area
    std::vector<EdgeOrigin> origins{};     ///< of the edge from each point to the next one
};

/// The part of an area that a window keeps. Both are regions of any shape: `area` is filled where
/// its region is kept, and `window` says by its `keep` whether the part inside or outside it stays.
/// At least one of the two must not reach to infinity.
///
/// The result is the closure of the points off all edges that both keep. So where area and window
/// merely touch, in points or along edges, there is nothing.
/// 1. Where edges meet, the order of these places and what is inside are decided exactly, for all
///    finite numbers. So it is exact whether the part is None, Whole or Cut, except for edges of
///    the area that have inside on neither side: one outside the window makes a whole area Cut, and
///    if there are no others, None may be Whole.
/// 2. A corner that is a corner of an input edge is returned bit for bit, except that -0 becomes 0.
///    Every other corner is the exact point with each coordinate rounded once to the nearest
///    double: it is off by at most half an ulp of that coordinate, and lies on a horizontal or
///    vertical edge bit for bit.
/// 3. The result is on the left of each edge, if y points up: outer rings are counter-clockwise,
///    holes clockwise, and the winding number is 1 inside and 0 outside, so both fill rules give
///    the same area. Before rounding, rings neither cross nor overlap; they may touch at corners,
///    and no ring visits a corner twice. Rounding may let edges nearer than an ulp touch or cross;
///    edges and rings that it makes empty are left out.
/// 4. Where edges of the area and of the window coincide, the area's edge is the origin; of several
///    edges of one input, the one with the smallest number.
///
/// Takes O(edges) in ordinary drawings, O(edges log edges) where long edges are beside each other,
/// plus what is needed to sort the crossings. Of the window, only the edges near the area count.
/// Edges that cross one another thousands of times take many seconds: when a stop is requested, the
/// call returns within some hundredths of a second, or after preparing the area.
ClippedArea clipArea(const PreparedRegion& area, const PreparedRegion& window,
                     const std::stop_token& stop = {});

/// The same for one area, which is prepared first. An area that is clipped more than once should be
/// prepared once.
ClippedArea clipArea(const Area& area, const PreparedRegion& window,
                     const std::stop_token& stop = {});

} // namespace clipping
