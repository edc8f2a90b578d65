// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/area_outline.h"

#include "app/cut/curve_at_edge.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

/// An edge of the result, or a run of edges along one curve.
struct Side {
    std::size_t subpath = 0, segment = 0; ///< of the curve, if it is one
    bool curved = false;
    double from = 0, to = 1; ///< parameters on the curve; `from > to` against its direction
    Point start{};           ///< where the side begins
    const clipping::Segment* window = nullptr; ///< the window's edge that it runs along
    Chord first{}, last{};                     ///< of the curve, in the direction of the side
    /// The side begins, or ends, beside the curve: a short line leads to it.
    bool missesStart = false, missesEnd = false;
};

bool goesOn(const Side& side, const Side& next)
{
    return side.curved && next.curved && side.subpath == next.subpath
           && side.segment == next.segment && side.to == next.from
           && (side.from < side.to) == (next.from < next.to);
}

/// The rings of a clipped area, one after the other.
class Rings {
public:
    Rings(const clipping::ClippedArea& clipped, const std::vector<Subpath>& path,
          const FlatArea& flat, const clipping::PreparedRegion& windows)
        : clipped_(clipped), path_(path), flat_(flat), windows_(windows)
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
        if (!ring.segments.back().curved)
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
            return side;
        }
        const auto& source = flat_.sources[origin.number - 1];
        if (!source || !isCurve(path_[source->subpath], source->chord.pathSegment))
            return side;
        const Chord& chord = source->chord;
        const auto at = [&](double share) {
            return share == 0   ? chord.t0
                   : share == 1 ? chord.t1
                                : chord.t0 + (chord.t1 - chord.t0) * share;
        };
        side.subpath = source->subpath;
        side.segment = chord.pathSegment;
        side.curved = true;
        side.from = at(origin.from);
        side.to = at(origin.to);
        side.first = side.last = chord;
        return side;
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

    // A curve meets the window's edge where it crosses it itself, not where its chord does.
    void meet(Side& side, Side& next)
    {
        if (side.curved && next.window)
            side.missesEnd = !refine(side, side.last, side.to, *next.window, next.start);
        else if (side.window && next.curved)
            next.missesStart = !refine(next, next.first, next.from, *side.window, next.start);
    }

    // False if the curve does not cross the edge: its chord cuts a corner that the curve misses.
    bool refine(const Side& side, const Chord& chord, double& t, const clipping::Segment& edge,
                Point& cut) const
    {
        if (t == chord.t0 || t == chord.t1)
            return true;
        const auto found = crossing(curveOf(path_[side.subpath], side.segment), chord, edge);
        if (!found)
            return false;
        t = found->t;
        cut = found->point;
        return true;
    }

    void append(const Side& side, const Point& end, std::vector<PathSegment>& segments) const
    {
        if (!side.curved)
            return segments.push_back({end});
        const Bezier curve = curveOf(path_[side.subpath], side.segment);
        if (side.missesStart)
            segments.push_back({curve.at(side.from)});
        const Bezier part = curve.part(std::min(side.from, side.to), std::max(side.from, side.to));
        const Point to = side.missesEnd ? curve.at(side.to) : end;
        segments.push_back(side.from < side.to
                               ? PathSegment{to, part.control1, part.control2, true}
                               : PathSegment{to, part.control2, part.control1, true});
        if (side.missesEnd)
            segments.push_back({end});
    }

    const clipping::ClippedArea& clipped_;
    const std::vector<Subpath>& path_;
    const FlatArea& flat_;
    const clipping::PreparedRegion& windows_;
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
                                const clipping::PreparedRegion& windows)
{
    std::vector<Subpath> subpaths;
    Rings rings(clipped, path, flat, windows);
    std::size_t first = 0;
    for (const std::uint32_t end : clipped.ringEnds) {
        subpaths.push_back(rings.ring(first, end));
        first = end;
    }
    return subpaths;
}

} // namespace app
