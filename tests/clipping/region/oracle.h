// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What a region keeps of a segment, found point by point in fractions: between any two places where
// the segment meets an edge, and at each place, every face around a point of it is looked at. F is
// Rational for any doubles, or a fraction of long long for small whole numbers. Shares no code with
// clipping/ except its plain types.

#include "clipping/region/region.h"

#include <algorithm>
#include <array>
#include <type_traits>
#include <vector>

#include "tests/clipping/rational.h"

namespace region_oracle {

using SmallFraction = boost::rational<long long>;

template <class F>
F fraction(double x)
{
    if constexpr (std::is_same_v<F, Rational>)
        return rational(x);
    else
        return F(static_cast<long long>(x));
}

template <class F>
struct Point {
    F x, y;
    friend bool operator==(const Point&, const Point&) = default;
    friend Point operator+(const Point& p, const Point& q) { return {p.x + q.x, p.y + q.y}; }
    friend Point operator-(const Point& p, const Point& q) { return {p.x - q.x, p.y - q.y}; }
    friend Point operator*(const F& f, const Point& p) { return {f * p.x, f * p.y}; }
};
template <class F>
F cross(const Point<F>& p, const Point<F>& q)
{
    return p.x * q.y - p.y * q.x;
}
template <class F>
F dot(const Point<F>& p, const Point<F>& q)
{
    return p.x * q.x + p.y * q.y;
}
template <class F>
struct Edge {
    Point<F> from, to;
    bool has(const Point<F>& p) const
    {
        return cross(Point<F>(to - from), Point<F>(p - from)) == F(0)
               && dot(Point<F>(from - p), Point<F>(to - p)) <= F(0);
    }
};

/// From one share of the way along the segment to another one.
template <class F>
struct Kept {
    F from, to;
};

template <class F>
class Truth {
public:
    explicit Truth(const clipping::Region& region) : region_(region)
    {
        for (const auto& step : region.steps) {
            edges_.emplace_back();
            const auto& [points, ends, rule] = step.area;
            std::size_t begin = 0;
            const auto ring = [&](std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    edges_.back().push_back(
                        {at(points[i]), at(points[i + 1 == end ? begin : i + 1])});
                begin = end;
            };
            for (const std::size_t end : ends)
                ring(end);
            if (ends.empty())
                ring(points.size());
        }
    }

    static Point<F> at(const glm::dvec2& p) { return {fraction<F>(p.x), fraction<F>(p.y)}; }
    static Point<F> pointOf(const clipping::Segment& s, const F& share)
    {
        return at(s.a) + share * (at(s.b) - at(s.a));
    }
    const std::vector<Edge<F>>& edges(std::size_t step) const { return edges_[step]; }

    bool keeps(const Point<F>& p) const
    {
        using enum clipping::AreaOperation;
        if (region_.steps.empty())
            return true;
        bool in = region_.steps[0].operation != Add;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const bool within = areaHas(i, p);
            const auto operation = region_.steps[i].operation;
            in = operation == Add      ? in || within
                 : operation == CutOut ? in && !within
                                       : in && within;
        }
        return in == (region_.keep == clipping::Keep::Inside);
    }

    std::vector<Kept<F>> kept(const clipping::Segment& s) const
    {
        const auto places = placesOn(s);
        std::vector<Kept<F>> all;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto joins = [&] { return !all.empty() && all.back().to == places[i]; };
            if (!joins() && keeps(pointOf(s, places[i])))
                all.push_back({places[i], places[i]});
            if (i + 1 == places.size() || !keeps(pointOf(s, (places[i] + places[i + 1]) / F(2))))
                continue;
            if (joins())
                all.back().to = places[i + 1];
            else
                all.push_back({places[i], places[i + 1]});
        }
        return all;
    }

private:
    /// Where the segment meets an edge or its line, and its ends: ascending.
    std::vector<F> placesOn(const clipping::Segment& s) const
    {
        if (s.a == s.b)
            return {F(0)};
        std::vector<F> all{F(0), F(1)};
        const Point<F> a = at(s.a), along = at(s.b) - a;
        const auto add = [&](const F& share) {
            if (share > F(0) && share < F(1))
                all.push_back(share);
        };
        for (const auto& edges : edges_)
            for (const auto& [from, to] : edges) {
                const Point<F> edge = to - from;
                if (const F under = cross(along, edge); under != F(0))
                    add(cross(Point<F>(from - a), edge) / under);
                else if (cross(along, Point<F>(from - a)) == F(0))
                    for (const auto& end : {from, to})
                        add(dot(Point<F>(end - a), along) / dot(along, along));
            }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    bool fills(std::size_t step, const Point<F>& p) const
    {
        int winding = 0;
        for (const auto& [from, to] : edges_[step]) {
            const bool above = from.y > p.y;
            if (above == (to.y > p.y))
                continue;
            const F side = cross(Point<F>(to - from), Point<F>(p - from));
            if (above ? side < F(0) : side > F(0))
                winding += above ? -1 : 1;
        }
        return region_.steps[step].area.rule == clipping::FillRule::NonZero ? winding != 0
                                                                            : winding % 2 != 0;
    }

    /// Whether a face around p is filled.
    bool areaHas(std::size_t step, const Point<F>& p) const
    {
        std::vector<Point<F>> rays;
        for (const auto& edge : edges_[step])
            if (edge.has(p))
                rays.insert(rays.end(), {edge.from - p, edge.to - p});
        std::erase(rays, Point<F>{F(0), F(0)});
        if (rays.empty())
            return fills(step, p);
        // With the axes, neighbouring directions are at most a quarter turn apart.
        for (const int sign : {1, -1})
            rays.insert(rays.end(), {{F(sign), F(0)}, {F(0), F(sign)}});
        const auto upper = [](const Point<F>& r) {
            return r.y > F(0) || (r.y == F(0) && r.x > F(0));
        };
        std::sort(rays.begin(), rays.end(), [&](const auto& r, const auto& t) {
            return upper(r) != upper(t) ? upper(r) : cross(r, t) > F(0);
        });
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const auto &here = rays[i], &next = rays[(i + 1) % rays.size()];
            if (cross(here, next) == F(0) && dot(here, next) > F(0))
                continue;
            const Point<F> between = here + next;
            if (fills(step, p + freeWay(step, p, between) * between))
                return true;
        }
        return false;
    }

    /// How far one may go from p in a direction, at most, without meeting an edge's line.
    F freeWay(std::size_t step, const Point<F>& p, const Point<F>& direction) const
    {
        F way(1);
        const auto limit = [&](const F& share) {
            if (share > F(0))
                way = std::min(way, share / F(2));
        };
        for (const auto& [from, to] : edges_[step]) {
            const Point<F> edge = to - from;
            if (const F under = cross(direction, edge); under != F(0))
                limit(cross(Point<F>(from - p), edge) / under);
            else
                for (const auto& end : {from, to})
                    limit(dot(Point<F>(end - p), direction) / dot(direction, direction));
        }
        return way;
    }

    const clipping::Region& region_;
    std::vector<std::vector<Edge<F>>> edges_;
};

} // namespace region_oracle
