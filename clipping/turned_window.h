// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace CLEARCUT_API clipping {

/// A closed rectangle turned about its centre, counter-clockwise if y points up. With c and s, the
/// cosine and sine of the angle in double, its frame has the axes u = (c, s) and v = (-s, c). A
/// point p is inside if its coordinates in the frame, (p - centre) . u and (p - centre) . v, are
/// at most `half` in magnitude. That is its exact definition, although c and s are rounded; for a
/// multiple of 90 degrees they are exact. It contains nothing if a number is not finite or a half
/// is negative.
struct TurnedWindow {
    glm::dvec2 centre; ///< in the drawing's unit
    glm::dvec2 half;   ///< half the width, and half the height, before it is turned
    double degrees;    ///< of its angle; any finite number
};

/// A window turned about its centre; centre and halves are rounded.
TurnedWindow turned(const Window& window, double degrees);

/// The four corners of a turned window, counter-clockwise, the first one at -half: each coordinate
/// is off by at most one ulp of the largest. Rounding may leave the corners of a window without
/// area, or of one much smaller than its distance from the origin, without a convex order.
ConvexPolygon cornersOf(const TurnedWindow& window);

/// K: how far off the functions below are with a form of this row, in ulps of M, the largest
/// |coordinate| of the segment and of the window's corners (derived in turned_window.cpp).
constexpr double turnedUlps(const Algorithm& algorithm) { return 6 * algorithm.ulps + 20; }

/// A form of any row, applied to a turned window: the segment is turned into the window's frame,
/// clipped there at the axis-aligned window from -half to half, and the piece is turned back.
///
/// With a corrected form:
/// 1. For finite input it returns the part inside the window, directed from a to b; a single common
///    point is a zero-length segment.
/// 2. An end that is not cut is returned bit for bit. A new end is, by K ulps of M on each axis,
///    at a point of the segment; and it is inside the window with its edges moved out by K ulps.
/// 3. It returns what is inside the window with its edges moved in by K ulps, except for K ulps at
///    the ends. Visibility can be wrong only where moving the edges out or in changes it; this is
///    true of `exact` too, whose form for polygons decides exactly at given corners.
///
/// In `Clipped::cut`, Left is the edge at -half.x in the frame, Right at half.x, Bottom at -half.y
/// and Top at half.y.
std::optional<Segment> clipTurned(const Functions<Segment, Window>& form, const Segment& segment,
                                  const TurnedWindow& window);

/// The type of `Functions::clipAll` for segments and windows.
using ClipAllAtWindow = decltype(Functions<Segment, Window>::clipAll);

/// Clips many segments, as `Functions::clipAll` does, with the same result as one by one. Allocates
/// nothing. Of the form it needs `clipAll` alone.
std::size_t clipAllTurned(ClipAllAtWindow clipAll, std::span<const Segment> in,
                          const TurnedWindow& window, std::span<Clipped> out);
inline std::size_t clipAllTurned(const Functions<Segment, Window>& form,
                                 std::span<const Segment> in, const TurnedWindow& window,
                                 std::span<Clipped> out)
{
    return clipAllTurned(form.clipAll, in, window, out);
}

/// The operations of the form in the frame; turning is not counted (eleven a segment to turn it,
/// and six a new end to turn that back).
OperationCounts countTurned(const Functions<Segment, Window>& form, std::span<const Segment> in,
                            const TurnedWindow& window);

/// How one segment is clipped, step by step, in the coordinates of the frame: the origin is the
/// window's centre, and x points along its width. So are the steps, the values and `visible`.
Trace traceTurned(const Functions<Segment, Window>& form, const Segment& segment,
                  const TurnedWindow& window);

} // namespace clipping
