// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/runs.h"

namespace app::svg {

/// A closed convex area with straight sides: what a clip path shows.
class ConvexRegion {
public:
    /// The area inside a closed path (any path counts as closed); curves as chords within
    /// `tolerance`. Nothing if it is not convex or has more than mostClipSides sides. An area
    /// without width is convex and shows nothing.
    static std::optional<ConvexRegion> of(const Subpath& path, double tolerance);

    enum class Position : std::uint8_t { Inside, Outside, Across };
    /// Of the convex hull of a path's points and control points. Across if in doubt.
    Position position(const Subpath& path) const;

    /// What the area shows of a chord. Cuts at sides that are parallel to an axis have exactly
    /// that side's coordinate and name an edge of that axis. A mere touch of a longer line is
    /// nothing.
    std::optional<KeptPart> clip(const Chord& chord, std::size_t index) const;

    /// The common part of the area and a polygon (Sutherland-Hodgman): where the polygon is in
    /// several pieces they hang together along the sides, which fills the same area.
    std::vector<Point> clip(std::vector<Point> polygon) const;

    std::size_t sides() const { return corners_.size(); }
    clipping::Window bounds() const;

private:
    double height(std::size_t side, const Point& p) const; ///< above the side; inside is positive
    Point crossing(std::size_t side, const Point& a, const Point& b) const;
    clipping::Edge edge(std::size_t side) const;
    const Point& next(std::size_t side) const { return corners_[(side + 1) % corners_.size()]; }

    std::vector<Point> corners_; ///< so that the inside is on the side's left (x right, y up)
};

} // namespace app::svg
