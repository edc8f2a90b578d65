// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"
#include "app/view/view.h"

#include <QString>

#include <vector>

namespace app {

/// The grid that is shown under the drawing. It starts at the top left corner of the paper.
struct Grid {
    /// Own: `spacing` along lines at `angle`, `down` across them.
    enum class Pattern : std::uint8_t { Square, Diagonal, Isometric, Own };
    enum class Marks : std::uint8_t { Lines, Dots };

    static constexpr double least = 1e-3, most = 1e6; ///< of the spacing, in millimetres

    bool shown = false;
    double spacing = 10; ///< between neighbouring points, in millimetres on paper
    Pattern pattern = Pattern::Square;
    Marks marks = Marks::Lines;
    double down = 10; ///< Own: the other spacing, in millimetres on paper
    double angle = 0; ///< Own: in degrees, counterclockwise from the right
    friend bool operator==(const Grid&, const Grid&) = default;

    /// For settings: "shown 10 square lines down=10 angle=0".
    QString text() const;
    /// Reads such a text; what it does not say is as usual.
    static Grid fromText(const QString& text);
};

/// The points of a grid at a zoom, where it may be coarser by a factor of 5, 25 …, so that its
/// points are at least 10 pixels apart on screen: `origin` + whole multiples of `u` and `v`.
struct GridPoints {
    Point origin, u, v;

    Point nearest(const Point& point) const;
};
GridPoints gridPoints(const Grid& grid, const Page& page, double zoom);

/// A line of the grid. Every fifth one is major.
struct GridLine {
    clipping::Segment line;
    bool major;
};
/// The lines of a grid in a rectangle.
std::vector<GridLine> gridLines(const Grid& grid, const Page& page, double zoom,
                                const clipping::Window& within);
/// The points of a grid in a rectangle, at most 100,000.
std::vector<Point> gridDots(const Grid& grid, const Page& page, double zoom,
                            const clipping::Window& within);

} // namespace app
