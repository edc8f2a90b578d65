// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contract of clipping/region/region.h, checked with fractions.

#include "clipping/region/catalogue.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "tests/clipping/region/oracle.h"
#include "tests/clipping/same_bits.h"

inline std::string exactly(const clipping::Segment& s, const clipping::Region& region)
{
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, "Segment{{%a, %a}, {%a, %a}}, %s", s.a.x, s.a.y, s.b.x,
                  s.b.y, region.keep == clipping::Keep::Inside ? "inside" : "outside");
    std::string text = buffer;
    for (const auto& [area, operation] : region.steps) {
        text += operation == clipping::AreaOperation::Add      ? " add"
                : operation == clipping::AreaOperation::CutOut ? " cut out"
                                                               : " intersect";
        text += area.rule == clipping::FillRule::NonZero ? " nonzero" : " evenodd";
        for (std::size_t i = 0; i < area.points.size(); ++i) {
            const bool begins = std::ranges::find(area.ringEnds, i) != area.ringEnds.end();
            std::snprintf(buffer, sizeof buffer, "%s {%a, %a}", begins ? " |" : "",
                          area.points[i].x, area.points[i].y);
            text += buffer;
        }
    }
    return text;
}

namespace region_contract {

using region_oracle::Point;
using region_oracle::Truth;

/// Whether x is the double nearest to an exact value.
inline bool isNearest(double x, const Rational& exact)
{
    const auto away = [&](double y) { return abs(rational(y) - exact); };
    const double below = std::nextafter(x, -INFINITY), above = std::nextafter(x, INFINITY);
    return (std::isinf(below) || away(x) <= away(below))
           && (std::isinf(above) || away(x) <= away(above));
}
inline bool isNearest(double x, const region_oracle::SmallFraction& exact)
{
    return x == double(exact.numerator()) / double(exact.denominator());
}

/// Whether an end is as promised: `number` is that of the edge which cut it.
template <class F>
std::string endFault(const Truth<F>& truth, const clipping::Segment& s, const F& share,
                     const glm::dvec2& end, std::uint32_t number,
                     const clipping::PreparedRegion& region)
{
    if (s.a != s.b && share == F(0) && !sameBits(end, s.a))
        return "the start has moved";
    if (s.a != s.b && share == F(1) && !sameBits(end, s.b))
        return "the end has moved";
    const Point<F> exact = truth.pointOf(s, share);
    if (!isNearest(end.x, exact.x) || !isNearest(end.y, exact.y))
        return "an end is not the nearest point";
    if (number == 0)
        return share == F(0) || share == F(1) ? "" : "not said to be cut";
    const auto [step, segment] = region.edge(number);
    const region_oracle::Edge<F> edge{truth.at(segment.a), truth.at(segment.b)};
    const auto& edges = truth.edges(step);
    if (std::ranges::none_of(edges,
                             [&](const auto& e) { return e.from == edge.from && e.to == edge.to; }))
        return "an edge that the area does not have";
    return edge.has(exact) ? "" : "not on the edge that is said to have cut it";
}

} // namespace region_contract

/// How the pieces of a segment break the contract; empty if they do not.
template <class F>
std::string fault(const std::vector<clipping::RegionPiece>& pieces, const clipping::Segment& s,
                  const region_oracle::Truth<F>& truth, const clipping::PreparedRegion& region)
{
    using region_contract::endFault;
    const auto kept = truth.kept(s);
    if (pieces.size() != kept.size())
        return std::to_string(pieces.size()) + " pieces instead of " + std::to_string(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const auto& [piece, source, edgeOfA, edgeOfB] = pieces[i];
        auto wrong = endFault(truth, s, kept[i].from, piece.a, edgeOfA, region);
        if (wrong.empty())
            wrong = endFault(truth, s, kept[i].to, piece.b, edgeOfB, region);
        if (!wrong.empty())
            return wrong;
    }
    return {};
}

/// The same for the reversed segment, whose pieces are the reversed ones.
inline std::string reversalFault(const std::vector<clipping::RegionPiece>& pieces,
                                 const std::vector<clipping::RegionPiece>& reversed)
{
    const bool same =
        std::equal(pieces.begin(), pieces.end(), reversed.rbegin(), reversed.rend(),
                   [](const clipping::RegionPiece& p, const clipping::RegionPiece& q) {
                       return sameBits(p.segment.a, q.segment.b)
                              && sameBits(p.segment.b, q.segment.a) && p.edgeOfA == q.edgeOfB
                              && p.edgeOfB == q.edgeOfA;
                   });
    return same ? "" : "differs from the reversed segment";
}

/// Both, for one segment; and whether every row that clips at regions gives the same pieces.
template <class F>
std::string faultAt(const clipping::Segment& s, const region_oracle::Truth<F>& truth,
                    const clipping::PreparedRegion& region)
{
    const auto pieces = clip(s, region);
    const auto same = [](const clipping::RegionPiece& p, const clipping::RegionPiece& q) {
        return sameBits(p.segment, q.segment) && p.edgeOfA == q.edgeOfA && p.edgeOfB == q.edgeOfB;
    };
    for (const clipping::RegionAlgorithm& row : clipping::regionAlgorithms())
        if (!std::ranges::equal(row.clip(s, region), pieces, same))
            return std::string(row.key) + " differs";
    const auto wrong = fault(pieces, s, truth, region);
    return wrong.empty() ? reversalFault(pieces, clip({s.b, s.a}, region)) : wrong;
}
