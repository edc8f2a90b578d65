// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/edge_words.h"
#include "app/base/variant.h"

#include <vector>

namespace app {

/// What the microscope shows: one variant clipping one line.
struct TracedLine {
    Variant variant{};
    clipping::Segment line{};
    clipping::Window window{};
    YAxis y = YAxis::Down;
    QString origin{};          ///< where the line comes from: "Line 217 of 420"
    bool windowIsPage = false; ///< the drawing has no clip window: the line is clipped at its page
    /// The corners of a window that is a convex polygon, as in clipping::ConvexPolygon; `window` is
    /// its bounding box then. Empty: the window is the rectangle.
    std::vector<glm::dvec2> corners{};
    friend bool operator==(const TracedLine&, const TracedLine&) = default;
};

/// The functions of a variant at convex polygons; null if it clips at rectangles only.
const clipping::Functions<clipping::Segment, clipping::ConvexPolygon>*
polygonUsesOf(const Variant& variant);

/// Why the line cannot be traced, and what to do; empty if it can.
QString refusalOf(const TracedLine& tracedLine);

} // namespace app
