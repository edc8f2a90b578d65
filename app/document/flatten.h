// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

#include <functional>

namespace app {

/// The curves' usual tolerance, on paper.
constexpr double flatteningMillimetres = 0.05;

/// The same in the page's user units.
inline double usualTolerance(const Page& page)
{
    return flatteningMillimetres / page.millimetresPerUnit();
}

/// Where a chord of a flattened path comes from: `pathSegment` (== segments.size(): the closing
/// line) and the part [t0, t1] of it.
struct Chord {
    clipping::Segment segment;
    std::size_t pathSegment;
    double t0, t1;
};

/// The path as chords no farther than `tolerance` (user units, > 0) from it, in order; consecutive
/// chords share their ends bit for bit. A path that is a single point is one zero-length chord.
void flatten(const Subpath& path, double tolerance, std::vector<Chord>& chords);

/// The same of one path segment that starts at `begin`: number `index` of its path.
void flatten(const Point& begin, const PathSegment& segment, std::size_t index, double tolerance,
             std::vector<Chord>& chords);

/// How many chords `flatten` makes of the path.
std::size_t chordCount(const Subpath& path, double tolerance);

} // namespace app
