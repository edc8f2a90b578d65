// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"
#include "app/cut/true_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {
namespace {

constexpr double justAfterStart = 1e-300; // only a subpath's first chord begins at 0

} // namespace

/// From a corner on, in the direction of the ring, while its curve runs along a line.
std::vector<Point> CurvedBorder::cornersAlong(const clipping::Segment& line, Place place) const
{
    std::vector<Point> corners{edgeAt(place).from};
    double last = 0, least = stillNear();
    const auto passes = [&](const Point& p) {
        const Where where = placeOn(line.a, line.b, p);
        least = std::min(least, where.distance);
        return where.distance <= stillNear() && where.share > std::exchange(last, where.share);
    };
    while (!edgeAt(place).isStraight() && std::ranges::all_of(between(place), passes)) {
        corners.push_back(endOf(place));
        if (areSame(corners.back(), line.b))
            return least <= near_ ? corners : std::vector<Point>{};
        if (!passes(corners.back()))
            break;
        place = after(place);
    }
    return {};
}

/// Whether a point is none of the border's corners, but very near to this one. A short way between
/// the two would be along no edge.
bool CurvedBorder::isBesideCorner(const Point& p, const Point& corner) const
{
    bool isCorner = false;
    forEdgesFrom(p, [&](std::uint32_t) { isCorner = true; });
    return !isCorner && glm::distance(p, corner) <= stillNear();
}

std::vector<Chord> CurvedBorder::linesAlong(const Chord& chord) const
{
    const auto& [a, b] = chord.segment;
    if (areSame(a, b))
        return {};
    std::vector<Point> corners;
    std::uint32_t first = ~0u; // the edges of the first ring count, as for curves
    const auto look = [&](const clipping::Segment& line, bool isForward) {
        forEdgesFrom(line.a, [&](std::uint32_t edge) {
            std::vector<Point> found;
            if (edge < first)
                found = cornersAlong(line, edges_[edge]);
            if (found.empty())
                return;
            if (!isForward)
                std::ranges::reverse(found);
            corners = std::move(found);
            first = edge;
        });
    };
    look({a, b}, true);
    look({b, a}, false);
    std::vector<Chord> chords;
    const auto at = [&](std::size_t k) {
        return k == 0 ? 0
               : k + 1 == corners.size()
                   ? 1
                   : std::max(placeOn(a, b, corners[k]).share, justAfterStart);
    };
    for (std::size_t i = 1; i < corners.size(); ++i)
        chords.push_back({{corners[i - 1], corners[i]}, chord.pathSegment, at(i - 1), at(i)});
    return chords;
}

/// Appends the chords of a path as `flatten` does, but of its true curves.
void CurvedBorder::flattenTruly(const Subpath& path, double tolerance,
                                std::vector<Chord>& chords) const
{
    const std::size_t first = chords.size();
    Point last = path.start;
    for (std::size_t i = 0; i < path.segments.size(); ++i) {
        if (!path.segments[i].curved) {
            flatten(last, path.segments[i], i, tolerance, chords);
            last = path.segments[i].to;
            continue;
        }
        const std::vector<CurvePoint> points = curveAt(path, i).points(tolerance);
        if (i == 0)
            last = points.front().point;
        for (std::size_t k = 1; k < points.size(); ++k) {
            chords.push_back({{last, points[k].point}, i, points[k - 1].t, points[k].t});
            last = points[k].point;
        }
    }
    if (path.segments.empty() || (path.closed && path.segments.back().to != path.start))
        chords.push_back({{last, path.start}, path.segments.size(), 0, 1});
    else if (path.segments.back().to == path.start) // also if divided there
        chords.back().segment.b = chords[first].segment.a;
}

void CurvedBorder::flattenAlong(const Path& path, double tolerance,
                                std::vector<Chord>& chords) const
{
    const std::size_t begin = chords.size();
    if (path.straight()) {
        flatten(path, tolerance, chords);
        const auto isOnBorder = [&](const Chord& chord) { return !linesAlong(chord).empty(); };
        if (isEmpty()
            || std::none_of(chords.begin() + std::ptrdiff_t(begin), chords.end(), isOnBorder))
            return;
        chords.resize(begin);
    }
    for (const Subpath& subpath : path.subpaths())
        if (isEmpty() && sides_.empty()) {
            flattenTruly(subpath, tolerance, chords);
        } else {
            std::vector<Chord> plain;
            flattenTruly(subpath, tolerance, plain);
            if (isBeside(plain, tolerance))
                flattenAlong(subpath, plain, tolerance, chords);
            else
                chords.insert(chords.end(), plain.begin(), plain.end());
        }
}

void CurvedBorder::flattenAlong(const Subpath& path, std::span<const Chord> plain, double tolerance,
                                std::vector<Chord>& chords) const
{
    const auto segments = along(path, plain, tolerance);
    const std::size_t start = chords.size();
    Point at{};
    for (std::size_t i = 0; i < plain.size();) {
        const std::size_t segment = plain[i].pathSegment;
        const bool isCurved = segment < segments.size() && segments[segment];
        const Point& begin = plain[i].segment.a;
        if (i == 0 || glm::distance(at, begin) > (isCurved ? stillNear() : near_ / 1000))
            at = begin;
        if (isCurved) {
            flattenAlong(*segments[segment], at, chords);
            i += segments[segment]->plain.size();
            continue;
        }
        const std::vector<Chord> line = linesAlong(plain[i]);
        const auto parts = line.empty() ? plain.subspan(i, 1) : std::span(line);
        const std::size_t first = chords.size();
        chords.insert(chords.end(), parts.begin(), parts.end());
        if (line.empty())
            chords[first].segment.a = at;
        if (first > start && areSame(chords.back().segment.b, chords[start].segment.a))
            chords.back().segment.b = chords[start].segment.a;
        at = chords.back().segment.b;
        ++i;
    }
    // Beside the start the border may have two corners.
    const Point& begin = chords[start].segment.a;
    if (at != begin && isEdge(at, begin))
        chords.push_back({{at, begin}, plain.back().pathSegment, 1, 1});
}

bool CurvedBorder::isBeside(const clipping::Window& box) const
{
    bool is = !isFine(); // thousands of areas are everywhere
    if (is)
        return true;
    index_.meeting(box, 0, [&](std::uint32_t) { is = true; });
    if (!is)
        sidesAt_.meeting(box, 0, [&](std::uint32_t) { is = true; });
    return is;
}

bool CurvedBorder::isBeside(std::span<const Chord> chords, double tolerance) const
{
    clipping::Window box = around(chords.front().segment, 0);
    for (const Chord& chord : chords)
        box = {glm::min(box.min, chord.segment.b), glm::max(box.max, chord.segment.b)};
    const double by = tolerance + stillNear();
    return isBeside(clipping::Window{box.min - by, box.max + by});
}

bool CurvedBorder::isBeside(const Path& path) const
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    clipping::Window box{Point(infinite), Point(-infinite)};
    path.forEachPoint([&](const Point& p) { box = {glm::min(box.min, p), glm::max(box.max, p)}; });
    constexpr double strays = 1e-3; // an ellipse from the curve that draws it
    const double by = stillNear() + strays * glm::distance(box.min, box.max);
    return isBeside(clipping::Window{box.min - by, box.max + by});
}

/// Whether an edge of the border leads from a point to another one, in either direction.
bool CurvedBorder::isEdge(const Point& from, const Point& to) const
{
    bool is = false;
    for (const auto& [begin, end] : {std::pair(from, to), std::pair(to, from)})
        forEdgesFrom(begin, [&](std::uint32_t edge) {
            is = is || (edgeAt(edges_[edge]).from == begin && endOf(edges_[edge]) == end);
        });
    return is;
}

/// One curve, from `at`, and up to there.
void CurvedBorder::flattenAlong(const Along& along, Point& at, std::vector<Chord>& chords) const
{
    double t = 0;
    const auto go = [&](const Point& to, double until) {
        chords.push_back({{at, to}, along.plain.front().pathSegment, t, until});
        at = to, t = until;
    };
    auto next = along.near.ends.begin();
    const auto goPlainly = [&](const Point& to, double until) {
        for (; next != along.near.ends.end() && next->t < until; ++next)
            if (next->t > t)
                go(next->point, next->t);
        if (until > t)
            go(to, until);
    };
    for (const Shared& part : along.shared) {
        if (t == 0 && glm::distance(along.curve.at(part.low), along.curve.at(0)) <= stillNear()) {
            const bool isBeside = areSame(at, part.atLow) || isBesideCorner(at, part.atLow);
            if (at != part.atLow && (!isBeside || isEdge(at, part.atLow)))
                go(part.atLow, justAfterStart); // across the border, or along it
            else if (areSame(at, part.atLow) && along.plain.front().pathSegment > 0)
                chords.back().segment.b = part.atLow;
            at = part.atLow;
        } else if (part.low < t || (part.low == t && part.atLow != at)) {
            continue;
        }
        goPlainly(part.atLow, part.low);
        go(part.atHigh, part.high);
    }
    constexpr double late = 0.5; // a closed curve begins there, too
    const Point end = along.plain.back().segment.b;
    if (t > late && isBesideCorner(end, at)) {
        chords.back().t1 = 1;
        return;
    }
    goPlainly(end, 1);
    if (!areSame(at, end))
        go(end, 1);
}

} // namespace app
