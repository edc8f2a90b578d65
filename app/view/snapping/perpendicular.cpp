// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

namespace app {

SnapKind perpendicular()
{
    static constexpr clipping::Segment rightAngle[]{
        {{-1, -1}, {-1, 1}}, {{-1, 1}, {1, 1}}, {{-1, 0}, {0, 0}}, {{0, 0}, {0, 1}}};
    return {.key = "perpendicular",
            .name = Text::tr("Perpendicular"),
            .word = Text::tr("perpendicular"),
            .glyph = rightAngle,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                if (!near.from)
                    return;
                for (const auto* segments : {&near.lines, &near.windowEdges, &near.pageEdges})
                    for (const auto& segment : *segments)
                        if (const auto foot = footOn(segment, *near.from))
                            offers.add(*foot);
                for (const Bezier& curve : near.curves)
                    for (const Point& foot : feetOn(curve, *near.from))
                        offers.add(foot);
            }};
}

} // namespace app
