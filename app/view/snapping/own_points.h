// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The places by which a thing snaps that is moved as a whole.
struct OwnPoints {
    static constexpr std::size_t most = 64;

    std::vector<Point> points{};
    clipping::Window bounds{}; ///< its edges and middles are aligned
};

/// Those of a box: corners, middles of the edges, the centre.
OwnPoints ownPointsOf(const clipping::Window& box);

/// Those of objects: ends and middles of their lines and curves, and the corners and the centre of
/// their bounds. Of too many, those nearest to `grabbed` count, among the first 4,000.
OwnPoints ownPointsOf(const Document& document, const SceneLines& lines,
                      const ObjectRanges& objects, const clipping::Window& bounds,
                      const Point& grabbed);

} // namespace app
