// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contract of clipping/area/clip_area.h, as far as a result alone can show it.

#include "clipping/area/clip_area.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/clipping/rational.h"
#include "tests/clipping/same_bits.h"

namespace area_contract {

using clipping::ClippedArea;

/// Calls `visit(index, from, to)` for each edge of a result.
template <class Visit>
void forEdges(const ClippedArea& result, Visit&& visit)
{
    std::size_t begin = 0;
    for (const std::size_t end : result.ringEnds) {
        for (std::size_t i = begin; i < end; ++i)
            visit(i, result.points[i], result.points[i + 1 == end ? begin : i + 1]);
        begin = end;
    }
}

/// The winding number of a result at a point; nothing if an edge is too near to tell.
inline std::optional<int> windingAt(const ClippedArea& result, const glm::dvec2& p, double near)
{
    int winding = 0;
    bool isSure = true;
    forEdges(result, [&](std::size_t, const glm::dvec2& from, const glm::dvec2& to) {
        const double low = std::min(from.y, to.y), high = std::max(from.y, to.y);
        if (p.y < low - near || p.y > high + near || std::max(from.x, to.x) < p.x - near)
            return;
        const double side = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
        const double length = std::abs(to.x - from.x) + std::abs(to.y - from.y);
        isSure = isSure && p.y > low + near && p.y < high - near && std::abs(side) > near * length;
        if (from.y > to.y ? side < 0 : side > 0)
            winding += from.y > to.y ? -1 : 1;
    });
    return isSure ? std::optional(winding) : std::nullopt;
}

/// The exact area of a result: positive, as its outer rings are counter-clockwise.
inline Rational exactArea(const ClippedArea& result)
{
    // In whole multiples of the lowest bit of all numbers.
    using Whole = Rational::int_type;
    int lowest = 0;
    for (const auto& p : result.points)
        for (const double x : {p.x, p.y})
            if (x != 0)
                lowest = std::min(lowest, std::ilogb(x) - 52);
    const auto whole = [&](double x) {
        return x == 0 ? Whole(0) : Whole((rational(x) * Rational(Whole(1) << -lowest)).numerator());
    };
    Whole twice = 0;
    forEdges(result, [&](std::size_t, const glm::dvec2& from, const glm::dvec2& to) {
        twice += whole(from.x) * whole(to.y) - whole(from.y) * whole(to.x);
    });
    return Rational(twice, Whole(1) << (1 - 2 * lowest));
}

/// How the edges break what is promised of their origins; empty if they do not. `reach` is the
/// largest number.
inline std::string originFault(const ClippedArea& result, const clipping::PreparedRegion& area,
                               const clipping::PreparedRegion& window, double reach)
{
    if (result.points.size() != result.origins.size())
        return "not one origin for each point";
    std::string fault;
    forEdges(result, [&](std::size_t i, const glm::dvec2& from, const glm::dvec2& to) {
        const auto& [number, isOfWindow, begin, end] = result.origins[i];
        const auto source = (isOfWindow ? window : area).edge(number).segment;
        const auto at = [&](double share) { return source.a * (1 - share) + source.b * share; };
        const double near = 8 * reach * 0x1p-52;
        if (from == to)
            fault = "an edge is a point";
        // Two points that are nearer than a rounding of their places may have the same share.
        const bool isTiny = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y)) <= near;
        if (!(begin >= 0 && begin <= 1 && end >= 0 && end <= 1 && (begin != end || isTiny)))
            fault = "wrong shares";
        for (const auto& [share, p] : {std::pair(begin, from), std::pair(end, to)}) {
            if ((share == 0 && p != source.a) || (share == 1 && p != source.b))
                fault = "an end is not that of its edge";
            if (std::abs(at(share).x - p.x) > near || std::abs(at(share).y - p.y) > near)
                fault = "not at its share of the edge";
        }
    });
    return fault;
}

/// Whether two results are the same, bit for bit.
inline bool areTheSame(const ClippedArea& p, const ClippedArea& q)
{
    const auto sameOrigin = [](const clipping::EdgeOrigin& a, const clipping::EdgeOrigin& b) {
        return a.number == b.number && a.isOfWindow == b.isOfWindow && sameBits(a.from, b.from)
               && sameBits(a.to, b.to);
    };
    return p.part == q.part && p.ringEnds == q.ringEnds
           && std::ranges::equal(p.points, q.points,
                                 [](const auto& a, const auto& b) { return sameBits(a, b); })
           && std::ranges::equal(p.origins, q.origins, sameOrigin);
}

/// Whether a ring visits a corner twice.
inline bool visitsTwice(const ClippedArea& result)
{
    std::size_t begin = 0;
    for (const std::size_t end : result.ringEnds) {
        auto ring = std::vector(result.points.begin() + std::ptrdiff_t(begin),
                                result.points.begin() + std::ptrdiff_t(end));
        const auto before = [](const glm::dvec2& p, const glm::dvec2& q) {
            return p.x != q.x ? p.x < q.x : p.y < q.y;
        };
        std::sort(ring.begin(), ring.end(), before);
        if (std::adjacent_find(ring.begin(), ring.end()) != ring.end())
            return true;
        begin = end;
    }
    return false;
}

} // namespace area_contract
