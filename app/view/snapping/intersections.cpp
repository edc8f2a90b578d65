// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/block_grid.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

#include <algorithm>

namespace app {
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

} // namespace app
