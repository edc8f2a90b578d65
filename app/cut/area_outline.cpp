// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/area_outline.h"

#include "app/cut/true_curve.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// An edge of the result, or a run of edges along one curve.
struct Side {
    std::size_t subpath = 0, segment = 0; ///< of the curve, or of a line along the window's curve
    bool curved = false, isPart = false;  ///< whether it is a part of such a line
    const TrueCurve* border = nullptr;    ///< the window's curve that it runs along
    double from = 0, to = 1; ///< parameters on the curve; `from > to` against its direction
    bool isForward = true;   ///< as found at the polygons
    Point start{};           ///< where the side begins
    const clipping::Segment* window = nullptr; ///< the window's edge that it runs along
    Chord first{}, last{};                     ///< of the path, in the direction of the side
    /// The side begins, or ends, beside the curve: a short line leads to it.
    bool missesStart = false, missesEnd = false;
    int passed = 0; ///< so many of a window side's ends are where a line ends before it meets it
};

bool goesOn(const Side& side, const Side& next)
{
    const bool areParts = (side.curved && next.curved) || (side.isPart && next.isPart);
    const bool areOfOne =
        side.border ? side.border == next.border
                    : areParts && side.subpath == next.subpath && side.segment == next.segment;
    return areOfOne && side.isForward == next.isForward && side.to == next.from;
}

/// The rings of a clipped area, one after the other.
class Rings {
public:
    Rings(const clipping::ClippedArea& clipped, const std::vector<Subpath>& path,
          const FlatArea& flat, const clipping::PreparedRegion& windows, const CurvedBorder& border)
        : clipped_(clipped), path_(path), flat_(flat), windows_(windows), border_(border)
    {
    }

    Subpath ring(std::size_t first, std::size_t end)
    {
        takeSides(first, end);
        joinCurves();
        for (std::size_t i = 0; i < sides_.size(); ++i)
            meet(sides_[i], sides_[(i + 1) % sides_.size()]);
        Subpath ring{sides_.front().start, {}, true};
        for (std::size_t i = 0; i < sides_.size(); ++i)
            append(sides_[i], sides_[(i + 1) % sides_.size()].start, ring.segments);
        if (!ring.segments.empty() && !ring.segments.back().curved)
            ring.segments.pop_back(); // the closing line
        return ring;
    }

private:
    void takeSides(std::size_t first, std::size_t end)
    {
        sides_.clear();
        edges_.clear();
        edges_.reserve(end - first);
        for (std::size_t i = first; i < end; ++i)
            sides_.push_back(sideOf(clipped_.points[i], clipped_.origins[i]));
    }

    Side sideOf(const Point& start, const clipping::EdgeOrigin& origin)
    {
        Side side{.start = start};
        if (origin.isOfWindow) {
            edges_.push_back(windows_.edge(origin.number).segment);
            side.window = &edges_.back();
            if (const auto part = border_.partAlong(edges_.back()))
                takeParameters(side, *part, origin);
            return side;
        }
        const auto& source = flat_.sources[origin.number - 1];
        if (!source)
            return side;
        const Chord& chord = source->chord;
        side.first = side.last = chord;
        side.curved = isCurve(path_[source->subpath], chord.pathSegment);
        side.isPart = !side.curved && (chord.t0 > 0 || chord.t1 < 1);
        if (!side.curved && !side.isPart)
            return side;
        side.subpath = source->subpath;
        side.segment = chord.pathSegment;
        takeParameters(side, {nullptr, chord.t0, chord.t1}, origin);
        return side;
    }

    static void takeParameters(Side& side, const CurvePart& part,
                               const clipping::EdgeOrigin& origin)
    {
        side.border = part.curve;
        side.from = part.parameterAt(origin.from);
        side.to = part.parameterAt(origin.to);
        side.isForward = side.from < side.to;
    }

    // Begins where one curve does not go on, so that no curve is divided at the ring's start.
    void joinCurves()
    {
        for (std::size_t i = 0; i < sides_.size(); ++i)
            if (!goesOn(sides_[(i + sides_.size() - 1) % sides_.size()], sides_[i])) {
                std::ranges::rotate(sides_, sides_.begin() + std::ptrdiff_t(i));
                break;
            }
        std::vector<Side> joined;
        for (const Side& side : sides_)
            if (!joined.empty() && goesOn(joined.back(), side)) {
                joined.back().to = side.to;
                joined.back().last = side.last;
            } else {
                joined.push_back(side);
            }
        sides_ = std::move(joined);
    }

    // A curve, or a line at a curved border, ends where it meets that itself, not at the polygons.
    void meet(Side& side, Side& next)
    {
        if (!side.window && next.window)
            side.missesEnd = !meet(side, side.last, side.to, next, next.from, next.start);
        else if (side.window && !next.window)
            next.missesStart = !meet(next, next.first, next.from, side, side.to, next.start);
        else if (!side.window && !next.window)
            meetItself(side, next);
    }

    // Where the path crosses itself.
    void meetItself(Side& side, Side& next) const
    {
        const auto ends = [&](const Chord& chord) {
            return next.start == chord.segment.a || next.start == chord.segment.b;
        };
        if (!(side.curved || next.curved) || (ends(side.last) && ends(next.first)))
            return;
        const auto curveOf = [&](const Side& of) {
            return border_.curveAt(path_[of.subpath], of.segment);
        };
        if (!side.curved || !next.curved) {
            Side& curved = side.curved ? side : next;
            const auto& [chord, line] = side.curved ? std::pair(side.last, next.first.segment)
                                                    : std::pair(next.first, side.last.segment);
            if (const auto met = crossing(curveOf(curved), chord, line)) {
                (side.curved ? side.to : next.from) = met->t;
                next.start = met->point;
            }
            return;
        }
        const TrueCurve curve = curveOf(side), other = curveOf(next);
        const auto met = meetingNear(curve, side.last, {&other, next.first.t0, next.first.t1},
                                     {side.to, next.from});
        if (!met || met->t < 0 || met->t > 1 || met->u < 0 || met->u > 1)
            return;
        const Point p = curve.at(met->t);
        constexpr double rounding = 1e-9;
        const auto& [a, b] = side.last.segment;
        if (glm::distance(p, other.at(met->u)) > rounding * glm::distance(a, b))
            return;
        side.to = met->t;
        next.from = met->u;
        next.start = p;
    }

    // False if the curve does not cross the edge: its chord cuts a corner that the curve misses.
    bool meet(const Side& own, const Chord& chord, double& t, Side& window, double& onWindow,
              Point& cut) const
    {
        if (cut == chord.segment.a || cut == chord.segment.b)
            return true;
        const auto curve = own.curved
                               ? std::optional(border_.curveAt(path_[own.subpath], own.segment))
                               : std::nullopt;
        if (window.border) {
            const auto met =
                curve ? border_.meeting(*curve, chord, cut) : border_.meeting(chord.segment, cut);
            if (met && met->border == window.border) {
                cut = met->point;
                window.passed += !curve && (cut == chord.segment.a || cut == chord.segment.b);
                t = met->t;
                onWindow = met->onBorder;
                return true;
            }
        }
        const auto found = curve ? crossing(*curve, chord, *window.window) : std::nullopt;
        if (found) {
            t = found->t;
            cut = found->point;
        }
        return found || !curve;
    }

    void append(const Side& side, const Point& end, std::vector<PathSegment>& segments) const
    {
        if (side.passed == 2 && side.start == end)
            return; // both lines end between the window's curve and its chord
        const bool isCurved = side.curved || side.border;
        if (!isCurved || side.from == side.to || (side.from < side.to) != side.isForward)
            return segments.push_back({end});
        if (side.border)
            return side.border->append(segments, side.from, side.to, side.start, end);
        const TrueCurve curve = border_.curveAt(path_[side.subpath], side.segment);
        const Point start = side.missesStart ? curve.at(side.from) : side.start;
        if (side.missesStart)
            segments.push_back({start});
        curve.append(segments, side.from, side.to, start, side.missesEnd ? curve.at(side.to) : end);
        if (side.missesEnd)
            segments.push_back({end});
    }

    const clipping::ClippedArea& clipped_;
    const std::vector<Subpath>& path_;
    const FlatArea& flat_;
    const clipping::PreparedRegion& windows_;
    const CurvedBorder& border_;
    std::vector<Side> sides_;
    std::vector<clipping::Segment> edges_; ///< of the windows
};

} // namespace

FlatArea flatAreaOf(const std::vector<Subpath>& path, FillRule rule, std::span<const Chord> chords)
{
    FlatArea flat{{{}, {}, clipping::FillRule(rule)}};
    std::size_t next = 0;
    for (std::size_t subpath = 0; subpath < path.size(); ++subpath) {
        const std::size_t first = next;
        const auto begins = [](const Chord& chord) {
            return chord.pathSegment == 0 && chord.t0 == 0;
        };
        for (; next < chords.size() && (next == first || !begins(chords[next])); ++next) {
            flat.area.points.push_back(chords[next].segment.a);
            flat.sources.push_back(FlatArea::Source{subpath, chords[next]});
        }
        if (next > first && chords[next - 1].segment.b != path[subpath].start) {
            flat.area.points.push_back(chords[next - 1].segment.b);
            flat.sources.push_back(std::nullopt);
        }
        flat.area.ringEnds.push_back(std::uint32_t(flat.area.points.size()));
    }
    return flat;
}

std::vector<Subpath> subpathsOf(const clipping::ClippedArea& clipped,
                                const std::vector<Subpath>& path, const FlatArea& flat,
                                const clipping::PreparedRegion& windows, const CurvedBorder& border)
{
    std::vector<Subpath> subpaths;
    Rings rings(clipped, path, flat, windows, border);
    std::size_t first = 0;
    for (const std::uint32_t end : clipped.ringEnds) {
        if (Subpath ring = rings.ring(first, end); !ring.segments.empty())
            subpaths.push_back(std::move(ring));
        first = end;
    }
    return subpaths;
}

} // namespace app
