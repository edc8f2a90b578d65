// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What two regions keep together, found without clipping/ (except its plain types): point by point,
// and as an area cut into horizontal slabs at every height where edges begin, end or cross. F is
// Rational for any doubles, or a fraction of long long for small whole numbers.

#include "clipping/region/region.h"

#include <algorithm>
#include <array>

#include "tests/clipping/region/oracle.h"

template <class F>
class AreaTruth {
public:
    AreaTruth(const clipping::Region& area, const clipping::Region& window)
        : regions_{&area, &window}
    {
        for (std::size_t r = 0; r < 2; ++r)
            for (std::size_t i = 0; i < regions_[r]->steps.size(); ++i)
                addEdges(regions_[r]->steps[i].area, {r, i});
    }

    /// Whether a point off all edges is kept. In double, all numbers must be so short that this is
    /// exact.
    template <class N>
    bool keeps(const region_oracle::Point<N>& p) const
    {
        Windings windings = none();
        for (const auto& [segment, line, of] : edges_) {
            const auto from = numbers<N>(segment.a), to = numbers<N>(segment.b);
            const bool isAbove = from.y > p.y;
            if (isAbove == (to.y > p.y))
                continue;
            const N side = region_oracle::cross<N>(to - from, p - from);
            if (isAbove ? side < N(0) : side > N(0))
                windings[of.region][of.step] += isAbove ? -1 : 1;
        }
        return keeps(windings);
    }

    /// The area that is kept: `convert` turns exact lengths into numbers of type Sum, which are
    /// multiplied and added.
    template <class Sum, class Convert>
    Sum area(Convert convert) const
    {
        const auto heights = sortedHeights();
        Sum sum(0);
        for (std::size_t i = 0; i + 1 < heights.size(); ++i)
            sum += widthAt<Sum>((heights[i] + heights[i + 1]) / F(2), convert)
                   * convert(heights[i + 1] - heights[i]);
        return sum;
    }

private:
    struct Owner {
        std::size_t region, step;
    };
    struct Edge {
        clipping::Segment segment;
        region_oracle::Edge<F> line;
        Owner of;
    };
    using Windings = std::array<std::vector<int>, 2>;

    void addEdges(const clipping::Area& area, Owner of)
    {
        std::size_t begin = 0;
        auto ends = area.ringEnds;
        if (ends.empty())
            ends = {std::uint32_t(area.points.size())};
        for (const std::size_t end : ends) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto &p = area.points[i], &q = area.points[i + 1 == end ? begin : i + 1];
                edges_.push_back({{p, q}, {at(p), at(q)}, of});
            }
            begin = end;
        }
    }
    static region_oracle::Point<F> at(const glm::dvec2& p)
    {
        return {region_oracle::fraction<F>(p.x), region_oracle::fraction<F>(p.y)};
    }

    template <class N>
    static region_oracle::Point<N> numbers(const glm::dvec2& p)
    {
        if constexpr (std::is_same_v<N, double>)
            return {p.x, p.y};
        else
            return {rational(p.x), rational(p.y)};
    }

    Windings none() const
    {
        return {std::vector<int>(regions_[0]->steps.size()),
                std::vector<int>(regions_[1]->steps.size())};
    }
    bool keeps(const Windings& windings) const
    {
        return keeps(*regions_[0], windings[0]) && keeps(*regions_[1], windings[1]);
    }
    static bool keeps(const clipping::Region& region, const std::vector<int>& windings)
    {
        using enum clipping::AreaOperation;
        if (region.steps.empty())
            return true;
        bool in = region.steps[0].operation != Add;
        for (std::size_t i = 0; i < windings.size(); ++i) {
            const bool within = region.steps[i].area.rule == clipping::FillRule::NonZero
                                    ? windings[i] != 0
                                    : windings[i] % 2 != 0;
            const auto operation = region.steps[i].operation;
            in = operation == Add      ? in || within
                 : operation == CutOut ? in && !within
                                       : in && within;
        }
        return in == (region.keep == clipping::Keep::Inside);
    }

    std::vector<F> sortedHeights() const
    {
        std::vector<F> all;
        for (std::size_t i = 0; i < edges_.size(); ++i) {
            const auto& [from, to] = edges_[i].line;
            all.push_back(from.y);
            for (std::size_t j = 0; j < i; ++j) {
                const auto& [u, v] = edges_[j].line;
                const auto d = to - from, e = v - u;
                const F under = cross(d, e);
                if (under == F(0))
                    continue;
                const F share = cross(u - from, e) / under, other = cross(u - from, d) / under;
                if (share > F(0) && share < F(1) && other >= F(0) && other <= F(1))
                    all.push_back(from.y + share * d.y);
            }
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    /// How much of a horizontal line that meets no corner is kept.
    template <class Sum, class Convert>
    Sum widthAt(const F& y, Convert convert) const
    {
        struct Passed {
            F x;
            Owner of;
            int change;
        };
        std::vector<Passed> passed;
        for (const auto& [segment, line, of] : edges_)
            if (const bool isAbove = line.from.y > y; isAbove != (line.to.y > y))
                passed.push_back({line.from.x
                                      + (y - line.from.y) * (line.to.x - line.from.x)
                                            / (line.to.y - line.from.y),
                                  of, isAbove ? 1 : -1});
        std::sort(passed.begin(), passed.end(),
                  [](const Passed& p, const Passed& q) { return p.x < q.x; });
        Windings windings = none();
        Sum width(0);
        for (std::size_t i = 0; i < passed.size(); ++i) {
            if (i > 0 && keeps(windings))
                width += convert(passed[i].x - passed[i - 1].x);
            windings[passed[i].of.region][passed[i].of.step] += passed[i].change;
        }
        return width;
    }

    std::array<const clipping::Region*, 2> regions_;
    std::vector<Edge> edges_;
};
