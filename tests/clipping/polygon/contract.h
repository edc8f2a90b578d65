// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contract of clipping/algorithm.h for convex polygons (polygonUlps), checked with integers.

#include "clipping/algorithm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "tests/clipping/polygon/oracle.h"
#include "tests/clipping/rational.h"
#include "tests/clipping/same_bits.h"

using PolygonUses = clipping::Functions<clipping::Segment, clipping::ConvexPolygon>;

inline std::string exactly(const clipping::Segment& s, const clipping::ConvexPolygon& p)
{
    char buffer[200];
    std::snprintf(buffer, sizeof buffer, "Segment{{%a, %a}, {%a, %a}}, polygon", s.a.x, s.a.y,
                  s.b.x, s.b.y);
    std::string text = buffer;
    for (const auto& c : p.corners) {
        std::snprintf(buffer, sizeof buffer, " {%a, %a}", c.x, c.y);
        text += buffer;
    }
    return text;
}

/// The convex hull, counter-clockwise, exactly; points between two others on a line stay.
inline clipping::ConvexPolygon hullOf(std::vector<glm::dvec2> points)
{
    const auto turnsRight = [](const auto& p, const auto& q, const auto& r) {
        const Rational px = rational(p.x), py = rational(p.y);
        return (rational(q.x) - px) * (rational(r.y) - py)
               < (rational(q.y) - py) * (rational(r.x) - px);
    };
    std::ranges::sort(
        points, [](const auto& p, const auto& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2)
        return {points};
    std::vector<glm::dvec2> hull;
    for (int half = 0; half < 2; ++half) { // the lower one, then the upper one back
        const std::size_t start = hull.size();
        for (const auto& p : points) {
            while (hull.size() >= start + 2 && turnsRight(hull[hull.size() - 2], hull.back(), p))
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return {hull};
}

/// As one of many: says the edges, too.
inline std::optional<clipping::Clipped> clipOne(const PolygonUses& uses, const clipping::Segment& s,
                                                const clipping::ConvexPolygon& p)
{
    std::array<clipping::Clipped, 1> out;
    return uses.clipAll({&s, 1}, p, out) == 1 ? std::optional(out[0]) : std::nullopt;
}

namespace polygon_contract {

using Truth =
    polygon_oracle::Truth<boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                        boost::multiprecision::et_off>>;

constexpr int k = int(clipping::polygonUlps);

/// Whether p is, by k ulps, on the line of the edge with that number.
inline bool isOnEdge(const glm::dvec2& p, std::uint32_t number, const clipping::Segment& s,
                     const clipping::ConvexPolygon& polygon)
{
    const auto& c = polygon.corners;
    const auto &from = c[number - 1], &to = c[number % c.size()];
    long double largest = 0;
    for (const auto& q : c)
        largest = std::max({largest, (long double)std::abs(q.x), (long double)std::abs(q.y)});
    for (const auto& q : {s.a, s.b})
        largest = std::max({largest, (long double)std::abs(q.x), (long double)std::abs(q.y)});
    const long double ex = (long double)to.x - from.x, ey = (long double)to.y - from.y;
    const long double depth = ex * ((long double)p.y - from.y) - ey * ((long double)p.x - from.x);
    const long double ulp = std::max(largest * 0x1p-52L, 0x1p-1074L);
    return std::abs(depth) <= ulp * k * (std::abs(ex) + std::abs(ey));
}

} // namespace polygon_contract

/// How a result breaks the contract; empty if it does not.
inline std::string fault(const std::optional<clipping::Clipped>& found, const clipping::Segment& s,
                         const clipping::ConvexPolygon& polygon, bool decidesExactly)
{
    constexpr int k = polygon_contract::k;
    const polygon_contract::Truth truth(s, polygon);
    const auto part = truth.inside(0), least = truth.inside(-k);
    if (!found)
        return part && (decidesExactly || least) ? "lost" : "";
    const auto& [a, b] = found->segment;
    if (!part && (decidesExactly || !truth.inside(k)))
        return "seen where there is nothing";
    if (part && !(part->from < part->to) && decidesExactly && a != b)
        return "a contact that is no point";
    for (const auto& p : {a, b}) {
        const auto [lowX, highX] = std::ranges::minmax(polygon.corners, {}, &glm::dvec2::x);
        const auto [lowY, highY] = std::ranges::minmax(polygon.corners, {}, &glm::dvec2::y);
        if (!(p.x >= lowX.x && p.x <= highX.x && p.y >= lowY.y && p.y <= highY.y))
            return "outside the box";
        if (!truth.has(p, k))
            return "outside the polygon";
        if (!truth.isNear(p, k))
            return "off the segment";
    }
    if ((truth.has(s.a) && !sameBits(a, s.a)) || (truth.has(s.b) && !sameBits(b, s.b)))
        return "an inner end has moved";
    if (least && (truth.isAfter(least->from, a, k) || truth.isBefore(least->to, b, k)))
        return "a part is missing";
    const auto edgeA = clipping::polygonEdgeOfA(found->cut),
               edgeB = clipping::polygonEdgeOfB(found->cut);
    if ((edgeA == 0 && a != s.a) || (edgeB == 0 && b != s.b))
        return "not said to be cut";
    if ((edgeA != 0 && !polygon_contract::isOnEdge(a, edgeA, s, polygon))
        || (edgeB != 0 && !polygon_contract::isOnEdge(b, edgeB, s, polygon)))
        return "not on the edge that is said to have cut it";
    return {};
}
