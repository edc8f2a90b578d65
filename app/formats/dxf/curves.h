// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/arc_curves.h"
#include "app/formats/dxf/space.h"

#include <vector>

namespace app::dxf {

/// The part of an ellipse as seen from above. The axes are vectors from the centre.
EllipseArc arcOnPage(const Space& space, const glm::dvec3& centre, const glm::dvec3& axis1,
                     const glm::dvec3& axis2);

/// Appends an arc from the end of the path to `to`. Besides quarter turns it is divided where it is
/// farthest to each side, so that the bounds of the path are those of the arc.
void appendArc(Subpath& path, const EllipseArc& arc, const Point& to);

/// The arc as a path: from its begin to its end, or closed for a whole turn.
Subpath pathOf(const EllipseArc& arc);

/// A corner of a polyline, with the bulge of the arc that begins there: the tangent of a quarter of
/// its angle, positive if it turns counterclockwise. 0: a line begins there.
struct Corner {
    glm::dvec3 at{};
    double bulge = 0;
};
/// The polyline; empty without corners.
Subpath pathOf(const std::vector<Corner>& corners, bool closed, const Space& space);

} // namespace app::dxf
