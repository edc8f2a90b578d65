// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

namespace app {

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

} // namespace app
