// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace app::dxf {

/// A map of space that keeps lines straight: from the coordinates of an entity or a block, y up, to
/// those of the drawing. The identity changes no bit.
struct Space {
    glm::dmat3 axes{1};
    glm::dvec3 offset{0};

    glm::dvec3 operator()(const glm::dvec3& p) const { return axes * p + offset; }
    glm::dvec3 direction(const glm::dvec3& v) const { return axes * v; }
    /// The factor of lengths in the plane z = 0, seen from above: the root of that of areas.
    double scale() const;
};

Space operator*(const Space& after, const Space& before); ///< `before`, then `after`
Space moved(const glm::dvec3& by);
Space turned(double degrees); ///< counterclockwise in the plane z = 0; exact for right angles
Space scaled(const glm::dvec3& factors);

/// The coordinate system of an entity in the plane with this normal ("arbitrary axis algorithm").
/// A normal of length 0 counts as (0, 0, 1).
Space planeOf(const glm::dvec3& normal);

/// As seen from above, y down.
inline Point onPage(const glm::dvec3& p) { return {p.x, 0.0 - p.y}; }

} // namespace app::dxf
