// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/block_grid.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

#include <algorithm>

namespace app {

SnapKind ends()
{
    static constexpr clipping::Segment square[]{
        {{-1, -1}, {1, -1}}, {{1, -1}, {1, 1}}, {{1, 1}, {-1, 1}}, {{-1, 1}, {-1, -1}}};
    return {.key = "ends",
            .name = Text::tr("Ends"),
            .word = Text::tr("end"),
            .glyph = square,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& line : near.lines) {
                    offers.add(line.a);
                    offers.add(line.b);
                }
                for (const Bezier& curve : near.curves) {
                    offers.add(curve.from);
                    offers.add(curve.to);
                }
            }};
}

SnapKind middles()
{
    static constexpr clipping::Segment triangle[]{
        {{-1, 0.9}, {1, 0.9}}, {{1, 0.9}, {0, -0.9}}, {{0, -0.9}, {-1, 0.9}}};
    return {.key = "middles",
            .name = Text::tr("Middles"),
            .word = Text::tr("middle"),
            .glyph = triangle,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& line : near.lines)
                    offers.add(line.a + (line.b - line.a) * 0.5);
                for (const Bezier& curve : near.curves)
                    offers.add(curve.at(0.5));
            }};
}

SnapKind centres()
{
    static constexpr clipping::Segment crossInDiamond[]{
        {{0, -1}, {1, 0}},  {{1, 0}, {0, 1}},      {{0, 1}, {-1, 0}},
        {{-1, 0}, {0, -1}}, {{-0.4, 0}, {0.4, 0}}, {{0, -0.4}, {0, 0.4}}};
    return {.key = "centres",
            .name = Text::tr("Centres"),
            .word = Text::tr("centre"),
            .glyph = crossInDiamond,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const Point& centre : near.centres)
                    offers.add(centre);
            }};
}

namespace {

constexpr std::size_t mostPaired = 100; // 4,950 pairs

/// The nearest lines, chords and edges.
std::vector<clipping::Segment> nearest(const SnapSurroundings& near)
{
    std::vector<clipping::Segment> all = near.chords;
    all.insert(all.end(), near.windowEdges.begin(), near.windowEdges.end());
    all.insert(all.end(), near.pageEdges.begin(), near.pageEdges.end());
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (const double d = distance(near.pointer, all[i]); d <= near.radius)
            order.emplace_back(d, i);
    if (order.size() > mostPaired) {
        std::ranges::nth_element(order, order.begin() + mostPaired);
        order.resize(mostPaired);
    }
    std::vector<clipping::Segment> result;
    for (const auto& [d, i] : order)
        result.push_back(all[i]);
    return result;
}

} // namespace

SnapKind intersections()
{
    static constexpr clipping::Segment diagonals[]{{{-1, -1}, {1, 1}}, {{-1, 1}, {1, -1}}};
    return {.key = "intersections",
            .name = Text::tr("Intersections"),
            .word = Text::tr("intersection"),
            .glyph = diagonals,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                const auto lines = nearest(near);
                for (std::size_t i = 0; i < lines.size(); ++i)
                    for (std::size_t j = 0; j < i; ++j)
                        if (const auto shared = crossing(lines[i], lines[j]))
                            offers.add(*shared);
            }};
}

SnapKind perpendicular()
{
    static constexpr clipping::Segment rightAngle[]{
        {{-1, -1}, {-1, 1}}, {{-1, 1}, {1, 1}}, {{-1, 0}, {0, 0}}, {{0, 0}, {0, 1}}};
    return {.key = "perpendicular",
            .name = Text::tr("Perpendicular"),
            .word = Text::tr("perpendicular"),
            .glyph = rightAngle,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                if (!near.from)
                    return;
                for (const auto* segments : {&near.lines, &near.windowEdges, &near.pageEdges})
                    for (const auto& segment : *segments)
                        if (const auto foot = footOn(segment, *near.from))
                            offers.add(*foot);
                for (const Bezier& curve : near.curves)
                    for (const Point& foot : feetOn(curve, *near.from))
                        offers.add(foot);
            }};
}

SnapKind onPath()
{
    static constexpr clipping::Segment hourglass[]{
        {{-1, -1}, {1, -1}}, {{1, -1}, {-1, 1}}, {{-1, 1}, {1, 1}}, {{1, 1}, {-1, -1}}};
    return {.key = "on-path",
            .name = Text::tr("On path"),
            .word = Text::tr("on path"),
            .rank = SnapRank::Along,
            .usual = false,
            .glyph = hourglass,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& line : near.lines)
                    offers.add(nearestOn(line, near.pointer));
                for (const Bezier& curve : near.curves)
                    offers.add(nearestOn(curve, near.pointer));
            }};
}

} // namespace app
