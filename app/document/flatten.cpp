// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/flatten.h"

#include "app/document/bezier.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace app {
namespace {

constexpr int mostChords = 10'000; // for one curve of any size

// Common borders of shapes are drawn in both directions: from the lesser end on, they have the same
// chords bit for bit. In a loop the control points decide.
bool isBackwards(const Point& begin, const PathSegment& curve)
{
    const auto key = [](const Point& end, const Point& control) {
        return std::tuple(end.x, end.y, control.x, control.y);
    };
    return key(curve.to, curve.control2) < key(begin, curve.control1);
}

Bezier fromLesserEnd(const Point& begin, const PathSegment& curve, bool backwards)
{
    return backwards ? Bezier{curve.to, curve.control2, curve.control1, begin}
                     : Bezier{begin, curve.control1, curve.control2, curve.to};
}

// Wang's bound: the error of n chords of equal parameter length is at most |second difference| * 6
// / (8 n^2).
int chordCount(const Bezier& c, double tolerance)
{
    const double bend = std::max(glm::length(c.from - 2.0 * c.control1 + c.control2),
                                 glm::length(c.control1 - 2.0 * c.control2 + c.to));
    const double n = std::ceil(std::sqrt(0.75 * bend / tolerance));
    return n > 1 ? int(std::min<double>(n, mostChords)) : 1; // 1 also for NaN
}

} // namespace

void flatten(const Point& begin, const PathSegment& segment, std::size_t index, double tolerance,
             std::vector<Chord>& chords)
{
    if (!segment.curved) {
        chords.push_back({{begin, segment.to}, index, 0, 1});
        return;
    }
    const bool backwards = isBackwards(begin, segment);
    const Bezier curve = fromLesserEnd(begin, segment, backwards);
    const int n = chordCount(curve, tolerance);
    Point last = begin;
    for (int k = 1; k <= n; ++k) {
        const Point next = k == n ? segment.to : curve.at(double(backwards ? n - k : k) / n);
        chords.push_back({{last, next}, index, double(k - 1) / n, double(k) / n});
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
        const bool backwards = isBackwards(last, segment);
        count += segment.curved
                     ? std::size_t(chordCount(fromLesserEnd(last, segment, backwards), tolerance))
                     : 1;
        last = segment.to;
    }
    return count - (path.closed && !path.segments.empty() && last == path.start);
}

} // namespace app
