// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"
#include "app/cut/true_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double justAfterStart = 1e-300; // only a subpath's first chord begins at 0

/// The box so far around a chord.
clipping::Window around(const clipping::Segment& chord, double by)
{
    return {glm::min(chord.a, chord.b) - by, glm::max(chord.a, chord.b) + by};
}

} // namespace

std::optional<CurvedBorder::Shared> CurvedBorder::shared(const Place& place,
                                                         const TrueCurve& curve) const
{
    const Edge& edge = edgeAt(place);
    const Point end = endOf(place);
    if (isOf(edge, curve))
        return Shared{edge.t0, edge.t1, edge.from, end, true};
    double last = 0, first = 0, least = stillNear();
    int direction = 0;
    const auto passes = [&](const Point& p, bool begins) {
        const double t = curve.near(p), distance = glm::distance(curve.at(t), p);
        const double at = areSame(curve.at(t), curve.at(t < 0.5 ? 0 : 1)) ? std::round(t) : t;
        const int way = at > last ? 1 : at < last ? -1 : 0;
        const bool goesOn = begins || (way != 0 && (direction == 0 || way == direction));
        direction = begins ? 0 : way;
        last = at;
        if (begins)
            first = at;
        least = std::min(least, distance);
        return distance <= stillNear() && goesOn;
    };
    const auto isAlong = [&](const Point& p) { return passes(p, false); };
    if (!passes(edge.from, true) || !std::ranges::all_of(between(place), isAlong) || !isAlong(end))
        return std::nullopt;
    const bool isNear = least <= near_;
    return direction > 0 ? Shared{first, last, edge.from, end, isNear}
                         : Shared{last, first, end, edge.from, isNear};
}

CurvedBorder::Beside CurvedBorder::beside(const TrueCurve& curve, std::span<const Chord> plain,
                                          double tolerance) const
{
    const int parts = tolerance_ < tolerance ? int(std::sqrt(2 * tolerance / tolerance_)) + 1 : 1;
    Beside found;
    for (const auto& [chord, segment, t0, t1] : plain) {
        const double most = tolerance + near_;
        const std::size_t before = found.edges.size();
        starts_.meeting(around(chord, most), 0, [&](std::uint32_t edge) {
            if (placeOn(chord.a, chord.b, edgeAt(edges_[edge]).from).distance <= most)
                found.edges.push_back(edge);
        });
        const int count = found.edges.size() > before ? parts : 1;
        for (int k = 1; k < count; ++k) {
            const double t = t0 + (t1 - t0) * k / count;
            found.ends.push_back({t, curve.at(t)});
        }
        found.ends.push_back({t1, chord.b});
    }
    std::ranges::sort(found.edges);
    found.edges.erase(std::ranges::unique(found.edges).begin(), found.edges.end());
    return found;
}

std::vector<CurvedBorder::Shared>
CurvedBorder::sharedWith(const TrueCurve& curve, std::span<const std::uint32_t> near) const
{
    std::map<double, Shared> all;      // by their high ends
    for (const std::uint32_t i : near) // those of the first ring begin
        if (const auto found = shared(edges_[i], curve); found && found->low < found->high) {
            const auto after = all.upper_bound(found->low);
            if (after == all.end() || after->second.low >= found->high)
                all.emplace(found->high, *found);
        }
    std::vector<Shared> inOrder;
    std::size_t run = 0; // where the last one begins
    const auto endRun = [&] {
        const auto begin = inOrder.begin() + std::ptrdiff_t(run);
        if (std::none_of(begin, inOrder.end(), [](const Shared& part) { return part.isNear; }))
            inOrder.erase(begin, inOrder.end());
        run = inOrder.size();
    };
    for (const auto& [high, part] : all) {
        if (inOrder.size() > run && inOrder.back().atHigh != part.atLow)
            endRun();
        inOrder.push_back(part);
    }
    endRun();
    return inOrder;
}

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
    } else {
        for (const Subpath& subpath : path.subpaths())
            flattenTruly(subpath, tolerance, chords);
    }
    if (isEmpty())
        return;
    const auto isOnBorder = [&](const Chord& chord) { return !linesAlong(chord).empty(); };
    if (path.straight()
        && std::none_of(chords.begin() + std::ptrdiff_t(begin), chords.end(), isOnBorder))
        return;
    const std::vector<Chord> plain(chords.begin() + std::ptrdiff_t(begin), chords.end());
    chords.resize(begin);
    const std::vector<Subpath> subpaths = path.subpaths();
    std::size_t subpath = 0, start = begin; // the first chord of the subpath
    Point at{};
    for (std::size_t i = 0, end = 0; i < plain.size(); i = end) {
        const auto& [chord, segment, t0, t1] = plain[i];
        const bool begins = segment == 0 && t0 == 0;
        if (i > 0 && begins) {
            ++subpath;
            start = chords.size();
        }
        end = i + 1;
        while (end < plain.size() && plain[end].pathSegment == segment && plain[end].t0 != 0)
            ++end;
        const auto own = std::span(plain).subspan(i, end - i);
        const bool isCurved = isCurve(subpaths[subpath], segment);
        if (begins || !(areSame(at, chord.a) || (isCurved && isBesideCorner(chord.a, at))))
            at = chord.a;
        if (isCurved) {
            flattenAlong(subpaths[subpath], segment, own, tolerance, at, chords);
        } else {
            const std::vector<Chord> along = linesAlong(own.front());
            const auto parts = along.empty() ? own : std::span(along);
            const std::size_t first = chords.size();
            chords.insert(chords.end(), parts.begin(), parts.end());
            if (along.empty())
                chords[first].segment.a = at;
            if (first > start && areSame(chords.back().segment.b, chords[start].segment.a))
                chords.back().segment.b = chords[start].segment.a;
            at = chords.back().segment.b;
        }
    }
}

/// One curve, with the chords that it has elsewhere; from `at`, and up to there.
void CurvedBorder::flattenAlong(const Subpath& path, std::size_t segment,
                                std::span<const Chord> plain, double tolerance, Point& at,
                                std::vector<Chord>& chords) const
{
    const TrueCurve curve = curveAt(path, segment);
    const Beside near = beside(curve, plain, tolerance);
    double t = 0;
    const auto go = [&](const Point& to, double until) {
        chords.push_back({{at, to}, plain.front().pathSegment, t, until});
        at = to, t = until;
    };
    const auto goPlainly = [&](const Point& to, double until) {
        for (const CurvePoint& end : near.ends)
            if (end.t > t && end.t < until)
                go(end.point, end.t);
        if (until > t)
            go(to, until);
    };
    for (const Shared& part : sharedWith(curve, near.edges)) {
        if (part.low == 0 && t == 0) {
            if (areSame(at, part.atLow) || isBesideCorner(at, part.atLow))
                at = part.atLow;
            else
                go(part.atLow, justAfterStart); // across the border
        } else if (part.low < t || (part.low == t && part.atLow != at)) {
            continue;
        }
        goPlainly(part.atLow, part.low);
        go(part.atHigh, part.high);
    }
    constexpr double late = 0.5; // a closed curve begins there, too
    const Point end = plain.back().segment.b;
    if (t > late && isBesideCorner(end, at)) {
        chords.back().t1 = 1;
        return;
    }
    goPlainly(end, 1);
    if (!areSame(at, end))
        go(end, 1);
}

} // namespace app
