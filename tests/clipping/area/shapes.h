// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/area/clip_area.h"

#include "tests/clipping/random.h"
#include "tests/clipping/region/shapes.h"

/// A random area with corners on a small grid, where edges cross in one point, touch and coincide
/// all the time: one ring or two, with repeated points and rings there and back.
inline clipping::Area gridArea(Random& random, int size, int mostCorners)
{
    clipping::Area area;
    area.rule = random.whole(0, 1) ? clipping::FillRule::NonZero : clipping::FillRule::EvenOdd;
    for (int rings = random.whole(1, 4) / 4; rings >= 0; --rings) {
        for (int n = random.whole(3, mostCorners); n > 0; --n)
            area.points.push_back({random.whole(0, size), random.whole(0, size)});
        area.ringEnds.push_back(static_cast<std::uint32_t>(area.points.size()));
    }
    return area;
}

/// A rectangle, or up to three areas together; inside or outside is kept.
inline clipping::Region gridWindow(Random& random, int size)
{
    using namespace clipping;
    Region window{{}, random.whole(0, 1) ? Keep::Inside : Keep::Outside};
    if (random.whole(0, 2) == 0) {
        const glm::dvec2 low(random.whole(0, 3), random.whole(0, 3));
        window.steps.push_back({areaOf({low, {random.whole(3, 8), random.whole(3, 8)}})});
    } else {
        for (int n = random.whole(1, 3); n > 0; --n)
            window.steps.push_back(
                {gridArea(random, size, 5), AreaOperation(random.whole(0, 5) % 3)});
    }
    return window;
}
