// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"
#include "app/document/guide.h"
#include "app/view/grid.h"

#include <optional>
#include <vector>

namespace app {

/// What is near the pointer, for the kinds of places to snap to.
struct SnapSurroundings {
    Point pointer;
    double radius;                           ///< in user units
    std::optional<Point> from{};             ///< where the line that is being drawn begins
    std::vector<clipping::Segment> lines{};  ///< path segments that are lines, or single points
    std::vector<Bezier> curves{};            ///< path segments that are curves
    std::vector<clipping::Segment> chords{}; ///< all lines, and the chords of the curves
    std::vector<Point> centres{};
    std::vector<clipping::Segment> windowEdges{}; ///< of visible clip windows; none of curves
    std::vector<clipping::Segment> pageEdges{};
    std::vector<Guide> guides{};
    std::optional<GridPoints> grid{};
};

} // namespace app
