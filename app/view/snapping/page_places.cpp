// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

#include <cmath>

namespace app {

SnapKind pageEdges()
{
    static constexpr clipping::Segment sheet[]{{{-0.8, -1}, {0.3, -1}},
                                               {{0.3, -1}, {0.8, -0.5}},
                                               {{0.8, -0.5}, {0.8, 1}},
                                               {{0.8, 1}, {-0.8, 1}},
                                               {{-0.8, 1}, {-0.8, -1}}};
    return {.key = "page",
            .name = Text::tr("Page edges and corners"),
            .word = Text::tr("page edge"),
            .cornerWord = Text::tr("page corner"),
            .rank = SnapRank::Along,
            .glyph = sheet,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& edge : near.pageEdges) {
                    offers.addCorner(edge.a);
                    offers.add(nearestOn(edge, near.pointer));
                }
            }};
}

SnapKind gridKind()
{
    static constexpr clipping::Segment hash[]{{{-0.4, -1}, {-0.4, 1}},
                                              {{0.4, -1}, {0.4, 1}},
                                              {{-1, -0.4}, {1, -0.4}},
                                              {{-1, 0.4}, {1, 0.4}}};
    return {.key = "grid",
            .name = Text::tr("Grid"),
            .word = Text::tr("grid"),
            .rank = SnapRank::Grid,
            .glyph = hash,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                if (near.grid)
                    offers.add(near.grid->nearest(near.pointer));
            }};
}

SnapKind guideKind()
{
    static constexpr clipping::Segment cross[]{
        {{-1, 0.3}, {1, 0.3}}, {{-0.3, -1}, {-0.3, -0.2}}, {{-0.3, 0.8}, {-0.3, 1}}};
    return {.key = "guide",
            .name = Text::tr("Guides"),
            .word = Text::tr("guide"),
            .cornerWord = Text::tr("crossing of guides"),
            .rank = SnapRank::Along,
            .glyph = cross,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const Guide& guide : near.guides) {
                    Point on = near.pointer;
                    on[guide.axis] = guide.at;
                    offers.add(on);
                    for (const Guide& other : near.guides)
                        if (guide.axis < other.axis)
                            offers.addCorner({guide.at, other.at});
                }
            }};
}

// While a line is drawn: its direction along an axis. A short line near an axis may be meant as it
// is, so the angle counts, too. Grid points are on the axes already.
SnapKind axes()
{
    static constexpr clipping::Segment cross[]{{{-1, 0.8}, {1, 0.8}}, {{-0.8, -1}, {-0.8, 1}}};
    return {.key = "axes",
            .name = Text::tr("Horizontal and vertical"),
            .word = Text::tr("along an axis"),
            .rank = SnapRank::Along,
            .glyph = cross,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                if (!near.from || near.grid)
                    return;
                constexpr double slope = 0.05; // 3°
                const Point way = near.pointer - *near.from;
                if (std::abs(way.y) < slope * std::abs(way.x))
                    offers.add({near.pointer.x, near.from->y});
                if (std::abs(way.x) < slope * std::abs(way.y))
                    offers.add({near.from->x, near.pointer.y});
            }};
}

} // namespace app
