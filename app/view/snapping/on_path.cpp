// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

namespace app {

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
