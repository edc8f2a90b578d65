// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "clipping/algorithm.h"

#include <QString>

#include <vector>

namespace app {

/// The direction in which y grows on screen: down in drawings, up in lessons and figures. The
/// library's Top is the edge at ymax in either case.
enum class YAxis : std::uint8_t { Down, Up };

/// The edge as it is seen on screen with y up, as an index: 0 none, 1 left, 2 right, 3 bottom, 4
/// top.
constexpr std::size_t seenEdge(clipping::Edge edge, YAxis y)
{
    const auto at = static_cast<std::size_t>(edge);
    return y == YAxis::Down && at >= 3 ? 7 - at : at;
}

/// "the top edge", as seen on screen; empty for Edge::NoEdge.
QString edgeWords(clipping::Edge edge, YAxis y);

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
    QString unit{}; ///< of its numbers: "mm"; empty: they have none
    friend bool operator==(const TracedLine&, const TracedLine&) = default;
};

/// The functions of a variant at convex polygons; null if it clips at rectangles only.
const clipping::Functions<clipping::Segment, clipping::ConvexPolygon>*
polygonUsesOf(const Variant& variant);

/// Why the line cannot be traced, and what to do; empty if it can.
QString refusalOf(const TracedLine& tracedLine);

} // namespace app
