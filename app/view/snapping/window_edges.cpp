// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

namespace app {

SnapKind windowEdges()
{
    static constexpr clipping::Segment window[]{{{-1, -1}, {1, -1}},
                                                {{1, -1}, {1, 1}},
                                                {{1, 1}, {-1, 1}},
                                                {{-1, 1}, {-1, -1}},
                                                {{-1, 0.2}, {1, -0.4}}};
    return {.key = "window",
            .name = Text::tr("Window edges and corners"),
            .word = Text::tr("window edge"),
            .cornerWord = Text::tr("window corner"),
            .rank = SnapRank::Along,
            .glyph = window,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& edge : near.windowEdges) {
                    if (edge.a != edge.b) // otherwise an outermost point of an ellipse
                        offers.addCorner(edge.a);
                    offers.add(nearestOn(edge, near.pointer));
                }
            }};
}

} // namespace app
