// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

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

} // namespace app
