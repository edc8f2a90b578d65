// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <array>
#include <vector>

// The corners and the edges of the window in Skala's numbering.

namespace app {

/// Edge k joins corner k to the next corner; corner 0 is (xmin, ymin).
inline constexpr std::array edgesFromCorners{clipping::Edge::Bottom, clipping::Edge::Right,
                                             clipping::Edge::Top, clipping::Edge::Left};

/// The edges whose two corners lie on different sides of a line. Bit k of `pattern`: corner k lies
/// to the left of the line.
inline std::vector<clipping::Edge> crossedEdges(unsigned pattern)
{
    std::vector<clipping::Edge> crossed;
    for (unsigned k = 0; k < 4; ++k)
        if ((pattern >> k & 1U) != (pattern >> (k + 1) % 4 & 1U))
            crossed.push_back(edgesFromCorners[k]);
    return crossed;
}

} // namespace app
