// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/view/snapping/kinds.h"

#include <cmath>

namespace app {

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
