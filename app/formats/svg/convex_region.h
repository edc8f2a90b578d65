// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/runs.h"

namespace app::svg {

/// A closed convex area with straight sides: the visible area of a clip path.
class ConvexRegion {
public:
    /// The area inside a path, which counts as closed; curves are replaced by chords within
    /// `tolerance`. Empty if the path is not convex or has more than mostClipSides sides. An area
    /// without width is convex and contains nothing visible.
    static std::optional<ConvexRegion> of(const Subpath& path, double tolerance);

    enum class Position : std::uint8_t { Inside, Outside, Across };
    /// The position of the convex hull of a path's points and control points. Across if in doubt.
    Position position(const Subpath& path) const;

    /// The part of a chord inside the area. A cut at a side parallel to an axis has exactly that
    /// side's coordinate and names an edge of that axis. A single point of a longer line is
    /// dropped.
    std::optional<KeptPart> clip(const Chord& chord, std::size_t index) const;

    /// The intersection of the area and a polygon (Sutherland-Hodgman). Separate pieces are
    /// connected along the sides, which encloses the same area.
    std::vector<Point> clip(std::vector<Point> polygon) const;

    /// The side on which a point lies, apart from rounding.
    std::optional<clipping::Segment> sideAt(const Point& p) const;

    std::size_t sides() const { return corners_.size(); }
    clipping::Window bounds() const;

private:
    double height(std::size_t side, const Point& p) const; ///< above the side; inside is positive
    Point crossing(std::size_t side, const Point& a, const Point& b) const;
    clipping::Edge edge(std::size_t side) const;
    const Point& next(std::size_t side) const { return corners_[(side + 1) % corners_.size()]; }

    std::vector<Point> corners_; ///< ordered so that the inside is to the left of each side (x
                                 ///< right, y up)
};

} // namespace app::svg
