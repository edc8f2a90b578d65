// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/curved_border.h"
#include "app/cut/true_curve.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

// Where curves run along the border.

namespace app {
namespace {

bool areParallel(const Point& a, const Point& b)
{
    constexpr double much = 1e-3; // of a radian: it looks smooth
    return std::abs(cross(a, b)) <= much * glm::length(a) * glm::length(b) && glm::dot(a, b) > 0;
}

} // namespace

/// Where an edge ends, as it was found for the edge that begins there: the same bits.
std::optional<double> CurvedBorder::parameterAtEnd(const Place& place,
                                                   std::span<const Near> all) const
{
    const Place next = after(place);
    const auto key = [](const Place& p) { return std::pair(p.ring, p.edge); };
    const auto number =
        std::uint32_t(std::ranges::lower_bound(edges_, key(next), {}, key) - edges_.begin());
    const auto found = std::ranges::lower_bound(all, number, {}, &Near::edge);
    const bool isFound =
        found != all.end() && found->edge == number && key(edges_[number]) == key(next);
    return isFound ? std::optional(found->t) : std::nullopt;
}

std::optional<CurvedBorder::Shared>
CurvedBorder::shared(const Near& from, std::span<const Near> all, const TrueCurve& curve) const
{
    const Place& place = edges_[from.edge];
    const Edge& edge = edgeAt(place);
    const Point end = endOf(place);
    if (isOf(edge, curve))
        return Shared{edge.t0, edge.t1, edge.from, end, places, places};
    const auto ended = [&](double t) { // at an end of the curve
        constexpr double little = 0.01;
        const bool mayBe = std::abs(t - std::round(t)) <= little;
        return mayBe && areSame(curve.at(t), curve.at(std::round(t))) ? std::round(t) : t;
    };
    const double first = ended(from.t);
    double t = from.t, last = first;
    int direction = 0, near = from.distance <= near_, same = from.distance <= nearlySame();
    const auto passesAt = [&](const Point& p, double parameter) {
        t = parameter;
        const double distance = glm::distance(curve.at(t), p);
        near += distance <= near_;
        same += distance <= nearlySame();
        const double at = ended(t);
        const int way = at > last ? 1 : at < last ? -1 : 0;
        const bool goesOn = way != 0 && (direction == 0 || way == direction);
        direction = way;
        last = at;
        return distance <= stillNear() && goesOn;
    };
    const auto passes = [&](const Point& p) { return passesAt(p, curve.near(p, 0, 1, t)); };
    const bool isOnSame = edge.isCurved() && areSame(curve.ellipse(), sourceOf(edge).ellipse());
    if (isOnSame)
        near += places - 2, same += places - 2;
    if (from.distance > stillNear() || !(isOnSame || std::ranges::all_of(between(place), passes))
        || !passesAt(end, parameterAtEnd(place, all).value_or(curve.near(end, 0, 1, t))))
        return std::nullopt;
    return direction > 0 ? Shared{first, last, edge.from, end, near, same}
                         : Shared{last, first, end, edge.from, near, same};
}

CurvedBorder::Beside CurvedBorder::beside(const TrueCurve& curve, std::span<const Chord> plain,
                                          double tolerance) const
{
    const int parts = tolerance_ < tolerance ? int(std::sqrt(2 * tolerance / tolerance_)) + 1 : 1;
    Beside found;
    for (const auto& [chord, segment, t0, t1] : plain) {
        const double most = tolerance + near_, width = t1 - t0;
        const double low = std::max(t0 - width, 0.0), high = std::min(t1 + width, 1.0);
        const std::size_t before = found.edges.size();
        starts_.meeting(around(chord, most), 0, [&](std::uint32_t edge) {
            const Edge& beside = edgeAt(edges_[edge]);
            const Point& p = beside.from;
            const Where where = placeOn(chord.a, chord.b, p);
            if (where.distance > most)
                return;
            const double t = isOf(beside, curve)
                                 ? beside.t0
                                 : curve.near(p, low, high, t0 + where.share * width);
            found.edges.push_back({edge, t, glm::distance(curve.at(t), p)});
        });
        addSidesBeside(curve, {chord, segment, t0, t1}, tolerance, found.ends);
        bool isNear = found.edges.size() > before;
        if (isFine() && !isNear) // between the ends of an edge
            index_.meeting(around(chord, tolerance), 0, [&](std::uint32_t) { isNear = true; });
        const int count = isNear ? parts : 1;
        for (int k = 1; k < count; ++k) {
            const double t = t0 + width * k / count;
            found.ends.push_back({t, curve.at(t)});
        }
        found.ends.push_back({t1, chord.b});
    }
    std::ranges::sort(found.edges, {},
                      [](const Near& near) { return std::pair(near.edge, near.distance); });
    const auto same = std::ranges::unique(found.edges, {}, &Near::edge);
    found.edges.erase(same.begin(), same.end());
    addCorners(curve, found);
    return found;
}

void CurvedBorder::addShared(Along& along, bool own) const
{
    std::map<double, Shared> all; // by their high ends
    for (const Shared& shared : along.shared)
        all.emplace(shared.high, shared);
    for (const Near& each : along.near.edges) { // those of the first ring begin
        if (isOf(edgeAt(edges_[each.edge]), along.curve) != own)
            continue;
        const auto found = shared(each, along.near.edges, along.curve);
        if (!found || found->low >= found->high)
            continue;
        const auto after = all.upper_bound(found->low);
        if (after == all.end() || after->second.low >= found->high)
            all.emplace(found->high, *found);
    }
    along.shared.clear();
    for (const auto& [high, part] : all)
        along.shared.push_back(part);
}

/// Adds the ends where the curve passes corners of the border, so that its chords are on the same
/// side of them.
void CurvedBorder::addCorners(const TrueCurve& curve, Beside& near) const
{
    struct End {
        CurvePoint at;
        bool isCorner;
    };
    std::vector<End> ends;
    for (const auto& [edge, t, distance] : near.edges) {
        if (!isFine() || distance > touchesNear())
            continue;
        const Point &corner = edgeAt(edges_[edge]).from, p = curve.at(t);
        if (!areSame(p, curve.at(0)) && !areSame(p, curve.at(1)))
            ends.push_back({{t, areSame(p, corner) ? corner : p}, areSame(p, corner)});
    }
    if (ends.empty() && std::ranges::is_sorted(near.ends, {}, &CurvePoint::t))
        return;
    for (const CurvePoint& end : near.ends)
        ends.push_back({end, false});
    std::ranges::stable_sort(ends, {}, [](const End& end) { return end.at.t; });
    near.ends.clear();
    for (const auto& [at, isCorner] : ends)
        if (near.ends.empty() || at.t == 1 || !areSame(near.ends.back().point, at.point))
            near.ends.push_back(at);
        else if (isCorner)
            near.ends.back() = at;
}

/// Whether the border turns, or is another ring's, where an edge begins.
bool CurvedBorder::turnsAt(const Point& p) const
{
    bool turns = false;
    forEdgesFrom(p, [&](std::uint32_t number) {
        const Place& place = edges_[number];
        const auto& edges = rings_[place.ring].edges;
        const Edge &edge = edges[place.edge],
                   &before = edges[(place.edge + edges.size() - 1) % edges.size()];
        turns =
            turns || !edge.isCurved() || !before.isCurved()
            || (edge.source != before.source
                && !areParallel(sourceOf(before).slope(before.t1), sourceOf(edge).slope(edge.t0)));
    });
    return turns;
}

/// The edges along which a path runs, one after the other.
class CurvedBorder::Runs {
public:
    Runs(const CurvedBorder& border, const Subpath& path,
         std::vector<std::optional<Along>>& segments)
        : border_(border),
          isClosed_(!path.segments.empty() && path.segments.back().to == path.start),
          segments_(segments)
    {
        for (std::size_t i = 0; i < segments.size(); ++i)
            if (segments[i])
                for (Shared& shared : segments[i]->shared)
                    parts_.push_back({i, &shared});
        for (std::size_t i = 0; i < parts_.size(); ++i)
            parts_[i].goesOn = goesOn(parts_[i > 0 ? i - 1 : parts_.size() - 1], parts_[i], i > 0);
        const auto start = std::ranges::find(parts_, false, &Part::goesOn);
        isRing_ = start == parts_.end();
        if (!isRing_)
            std::ranges::rotate(parts_, start);
    }

    /// Two curves that cross at a small angle, or touch, are near to each other for a while, too.
    /// They are no borders of one thing, and meet as true curves do: where both go on smoothly at
    /// both ends of a run, and are the same nowhere.
    void dropTouches()
    {
        for (std::size_t i = 0, end = 0; i < parts_.size(); i = end) {
            for (end = i + 1; end < parts_.size() && parts_[end].goesOn;)
                ++end;
            const auto run = std::span(parts_).subspan(i, end - i);
            if (!isBorder(run))
                for (const Part& part : run)
                    part.shared->isTouch = true;
        }
        for (auto& segment : segments_)
            if (segment)
                std::erase_if(segment->shared, std::mem_fn(&Shared::isTouch));
    }

private:
    struct Part {
        std::size_t segment;
        Shared* shared;
        bool goesOn = false; ///< from the part before it
    };

    std::size_t before(std::size_t segment) const
    {
        return segment > 0 ? segment - 1 : segments_.size() - 1;
    }
    /// Whether the segment before it is a curve, too.
    bool isJoined(std::size_t segment) const
    {
        return segments_[before(segment)] && (segment > 0 || isClosed_);
    }
    bool goesOn(const Part& last, const Part& part, bool isLater) const
    {
        const bool isNext = isLater && last.segment == part.segment;
        const bool isOver = isJoined(part.segment) && last.segment == before(part.segment);
        return (isNext || isOver)
               && glm::distance(last.shared->atHigh, part.shared->atLow) <= border_.stillNear();
    }
    /// Whether the path begins or turns where a segment begins.
    bool turnsBefore(std::size_t segment) const
    {
        return !isJoined(segment)
               || !areParallel(segments_[before(segment)]->curve.slope(1),
                               segments_[segment]->curve.slope(0));
    }
    /// Whether the path or the border ends or turns at an end of a part.
    bool endsAt(const Part& part, bool high) const
    {
        const std::size_t next = part.segment + 1 < segments_.size() ? part.segment + 1 : 0;
        const Point& at = high ? part.shared->atHigh : part.shared->atLow;
        const bool isNode =
            glm::distance(at, segments_[part.segment]->curve.at(high)) <= border_.stillNear();
        const bool turns = high ? !segments_[next] || turnsBefore(next) : turnsBefore(part.segment);
        return (isNode && turns) || border_.turnsAt(at);
    }
    bool isBorder(std::span<const Part> run) const
    {
        int near = 0, same = 0;
        double length = 0;
        for (const Part& part : run) {
            near += part.shared->near;
            same += part.shared->same;
            length += glm::distance(part.shared->atLow, part.shared->atHigh);
        }
        if (near == 0)
            return false;
        const bool isLong = length > 4 * border_.stillNear(); // what crosses is near for a while
        const bool isSame = 2 * same >= places * int(run.size());
        return isRing_
               || (isLong && (isSame || endsAt(run.front(), false) || endsAt(run.back(), true)));
    }

    const CurvedBorder& border_;
    const bool isClosed_;
    std::vector<std::optional<Along>>& segments_;
    std::vector<Part> parts_;
    bool isRing_;
};

std::vector<std::optional<CurvedBorder::Along>>
CurvedBorder::along(const Subpath& path, std::span<const Chord> plain, double tolerance) const
{
    std::vector<std::optional<Along>> segments(path.segments.size());
    for (std::size_t i = 0, end = 0; i < plain.size(); i = end) {
        const std::size_t segment = plain[i].pathSegment;
        end = i + 1;
        while (end < plain.size() && plain[end].pathSegment == segment)
            ++end;
        if (!isCurve(path, segment))
            continue;
        Along& along = segments[segment].emplace(
            Along{curveAt(path, segment), plain.subspan(i, end - i), {}, {}});
        along.near = beside(along.curve, along.plain, tolerance);
        addShared(along, false);
    }
    if (isFine())
        Runs(*this, path, segments).dropTouches();
    for (auto& each : segments)
        if (each)
            addShared(*each, true);
    return segments;
}

} // namespace app
