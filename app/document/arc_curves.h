// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/bezier.h"
#include "app/document/subpath.h"

#include <optional>

// Arcs as cubic Bézier curves, as SVG draws them: of at most a quarter turn each, off by at most
// 0.03 % of the radius.

namespace app {

/// A part of an ellipse: the image of a part of the unit circle. Angles are in radians.
struct EllipseArc {
    Point centre, axis1, axis2; ///< the images of the angles 0 and π/2 are centre + axis
    double angle = 0;           ///< where it begins
    double sweep = 0;           ///< from there to its end

    Point at(double t) const;
    Point slope(double t) const;

    friend bool operator==(const EllipseArc&, const EllipseArc&) = default;
};

/// Appends the curves of an arc. The first one begins at `from`, the last one ends at `to`, bit for
/// bit.
void appendCurves(std::vector<PathSegment>& segments, const EllipseArc& arc, const Point& from,
                  const Point& to);

/// The rectangle with rounded corners. The radii are at most half the sides.
Subpath roundedRectangle(const Point& min, const Point& max, const Point& radii);

/// The ellipse of which a curve is a part of up to a quarter turn, if it is drawn as programs draw
/// such parts: in the middle and at the ends it is on the ellipse, elsewhere off by at most 0.03 %
/// of the radius. The curve may be off by 0.05 % in all, flatter ones by less. Straight curves, and
/// those shorter than 1/64 of a turn, have none.
std::optional<EllipseArc> ellipseOf(const Bezier& curve);

/// The angle of that point of an ellipse that is in the direction of another one, as seen from the
/// centre; from -π to π.
double angleTowards(const EllipseArc& ellipse, const Point& p);

/// The point of an ellipse in the direction of another one, as seen from its centre.
Point onEllipse(const EllipseArc& ellipse, const Point& p);

} // namespace app
