// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What the polygon tests share: polygons and segments made by dice, and text about them.

#include "clipping/algorithm.h"

#include <QTest>

#include <boost/multiprecision/cpp_int.hpp>
#include <cstring>
#include <string>

#include "tests/clipping/scenes.h"

using PolygonUses = clipping::Uses<clipping::Segment, clipping::ConvexPolygon>;

/// One column, every form for polygons of the catalogue: `uses`, and whether it decides exactly.
inline void everyPolygonForm()
{
    QTest::addColumn<const PolygonUses*>("uses");
    QTest::addColumn<bool>("decidesExactly");
    for (const clipping::Algorithm& a : clipping::algorithms()) {
        const bool exact = a.key != std::string_view("cyrus-beck");
        if (a.polygon)
            QTest::newRow(a.key.data()) << a.polygon << exact;
        if (a.searchedPolygon)
            QTest::addRow("%s, searched", a.key.data()) << a.searchedPolygon << exact;
    }
}

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

inline bool sameBits(const glm::dvec2& p, const glm::dvec2& q)
{
    return std::memcmp(&p, &q, sizeof p) == 0;
}

/// The convex hull, counter-clockwise, exactly; points between two others on a line stay.
inline clipping::ConvexPolygon hullOf(std::vector<glm::dvec2> points)
{
    using Rational = boost::multiprecision::cpp_rational;
    const auto turnsRight = [](const auto& p, const auto& q, const auto& r) {
        const Rational px(p.x), py(p.y);
        return (Rational(q.x) - px) * (Rational(r.y) - py)
               < (Rational(q.y) - py) * (Rational(r.x) - px);
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

/// A convex polygon of up to n corners near the origin, as large as `size`; one of four is slim, to
/// a width of 2^-40.
inline clipping::ConvexPolygon somePolygon(Dice& dice, int n, double size)
{
    const double turn = dice.uniform(0, 6.3), centreX = dice.uniform(-1, 1);
    const double width = dice.integer(0, 3) == 0 ? std::exp2(-dice.uniform(0, 40)) : 1;
    std::vector<glm::dvec2> points;
    for (int i = 0; i < n; ++i) {
        const double angle = dice.uniform(0, 6.283185307179586);
        const double x = std::cos(angle) + centreX, y = std::sin(angle) * width;
        points.push_back({size * (x * std::cos(turn) - y * std::sin(turn)),
                          size * (x * std::sin(turn) + y * std::cos(turn))});
    }
    return hullOf(points);
}
