// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

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

} // namespace app
