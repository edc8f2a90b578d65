// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <functional>

namespace app {

/// The usual tolerance for curves, on paper.
constexpr double flatteningMillimetres = 0.05;

/// The usual tolerance in user units of the page.
inline double usualTolerance(const Page& page)
{
    return flatteningMillimetres / page.millimetresPerUnit();
}

/// A chord of a flattened path. It approximates the part [t0, t1] of path segment `pathSegment`;
/// `pathSegment == segments.size()` is the closing line.
struct Chord {
    clipping::Segment segment;
    std::size_t pathSegment;
    double t0, t1;
};

/// Appends the chords of the path, in order, no farther than `tolerance` (user units, > 0) from it.
/// Consecutive chords share their ends bit for bit. A single point becomes one chord of length
/// zero.
void flatten(const Subpath& path, double tolerance, std::vector<Chord>& chords);

/// Flattens one path segment that starts at `begin`; `index` is its number in the path.
void flatten(const Point& begin, const PathSegment& segment, std::size_t index, double tolerance,
             std::vector<Chord>& chords);

/// The number of chords that `flatten` produces for the path.
std::size_t chordCount(const Subpath& path, double tolerance);

} // namespace app
