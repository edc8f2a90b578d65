// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tiles/tiling.h"

namespace app {

/// How sheets are shown: as windows over the drawing, or apart, as they are exported.
enum class SheetArrangement : std::uint8_t { InPlace, Apart };

/// A sheet in a layout, whose lengths are in millimetres on paper.
struct SheetPlace {
    clipping::Window part;  ///< of the drawing
    clipping::Window paper; ///< the part with its margins; in place only the part
    Point offset;           ///< of the drawing: layout = drawing × millimetresPerUnit + offset
};

/// The places of all sheets of a tiling, in their order. In place, the drawing is where it is.
struct SheetLayout {
    SheetArrangement arrangement;
    double millimetresPerUnit;
    std::vector<SheetPlace> places;
    clipping::Window bounds; ///< around all papers

    Point toLayout(std::size_t sheet, const Point& drawing) const
    {
        return drawing * millimetresPerUnit + places[sheet].offset;
    }
    Point toDrawing(std::size_t sheet, const Point& layout) const
    {
        return (layout - places[sheet].offset) / millimetresPerUnit;
    }
    /// The sheet whose paper contains a point; of several in place, the last one. Empty: none.
    std::optional<std::size_t> sheetAt(const Point& layout) const;
    /// The axis across an inner edge of sheets (0: the edge is vertical) that is within `reach` of
    /// a point; empty: there is none.
    std::optional<int> edgeAt(const Point& layout, double reach) const;
};

SheetLayout layoutOf(const Tiling& tiling, double margin, SheetArrangement arrangement);

} // namespace app
