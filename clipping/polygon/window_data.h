// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/convex_window.h"
#include "clipping/polygon/edge_table.h"

namespace clipping {

/// The prepared polygon of a ConvexWindow. Only a polygon with an area and ordinary numbers has a
/// table, for clipping with vector instructions.
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
