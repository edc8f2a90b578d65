// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/flatten.h"

#include "app/document/bezier.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int mostChords = 10'000; // for one curve of any size

// Wang's bound: the error of n chords of equal parameter length is at most |second difference| * 6
// / (8 n^2).
int chordCount(const Point& a, const PathSegment& c, double tolerance)
{
    const double bend = std::max(glm::length(a - 2.0 * c.control1 + c.control2),
                                 glm::length(c.control1 - 2.0 * c.control2 + c.to));
    const double n = std::ceil(std::sqrt(0.75 * bend / tolerance));
    return n > 1 ? int(std::min<double>(n, mostChords)) : 1; // 1 also for NaN
}

} // namespace

void flatten(const Point& begin, const PathSegment& segment, std::size_t index, double tolerance,
             std::vector<Chord>& chords)
{
    Point last = begin;
    const int n = segment.curved ? chordCount(begin, segment, tolerance) : 1;
    for (int k = 1; k <= n; ++k) {
        const double t = double(k) / n;
        const Point next =
            k == n ? segment.to
                   : Bezier{begin, segment.control1, segment.control2, segment.to}.at(t);
        chords.push_back({{last, next}, index, double(k - 1) / n, t});
        last = next;
    }
}

void flatten(const Subpath& path, double tolerance, std::vector<Chord>& chords)
{
    Point last = path.start;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        flatten(last, path.segments[i], i, tolerance, chords);
        last = path.segments[i].to;
    }
    if (path.segments.empty() || (path.closed && last != path.start))
        chords.push_back({{last, path.start}, path.segments.size(), 0, 1});
}

std::size_t chordCount(const Subpath& path, double tolerance)
{
    std::size_t count = path.segments.empty() || path.closed; // the closing line, or the point
    Point last = path.start;
    for (const PathSegment& segment : path.segments) {
        count += segment.curved ? std::size_t(chordCount(last, segment, tolerance)) : 1;
        last = segment.to;
    }
    return count - (path.closed && !path.segments.empty() && last == path.start);
}

} // namespace app
