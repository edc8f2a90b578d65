// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

namespace app {

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

} // namespace app
