// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

namespace app {

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

} // namespace app
