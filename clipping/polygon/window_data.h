// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/convex_window.h"
#include "clipping/polygon/edge_table.h"

namespace clipping {

/// What a ConvexWindow keeps. There is a table for vectors if the polygon has an area and its
/// numbers are ordinary.
struct ConvexWindow::Data {
    explicit Data(PreparedPolygon of) : polygon(std::move(of))
    {
        if (!polygon.flat && polygon.ordinary)
            table.emplace(polygon);
    }
    const PreparedPolygon polygon;
    std::optional<EdgeTable> table{};
};

} // namespace clipping
