// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

namespace app {

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

} // namespace app
