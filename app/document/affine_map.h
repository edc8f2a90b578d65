// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/placement.h"

#include <optional>

namespace app {

/// A transformation that keeps lines straight and parallel: the point `from` becomes `to`, exactly,
/// and a step of 1 along an axis from it becomes the vector `x` or `y`.
struct AffineMap {
    Point x{1, 0}, y{0, 1};
    Point from{0, 0}, to{0, 0};

    Point operator()(const Point& p) const
    {
        const Point step = p - from;
        return to + x * step.x + y * step.y;
    }
    /// The same map as a placement, if it neither rotates nor skews.
    std::optional<Placement> placement() const;
    /// The factor of lengths: the root of that of areas.
    double scale() const;
    bool isFinite() const;
    friend bool operator==(const AffineMap&, const AffineMap&) = default;
};

AffineMap translation(const Point& by);
/// Counterclockwise on screen; exact for multiples of 90°.
AffineMap rotation(double degrees, const Point& about);
/// A negative factor also mirrors.
AffineMap scaling(const Point& factors, const Point& about);
/// The lines along x stay horizontal; those along y lean to the right by `degrees`.
AffineMap horizontalSkew(double degrees, const Point& about);
/// The lines along y stay vertical; those along x rise to the right by `degrees`.
AffineMap verticalSkew(double degrees, const Point& about);

} // namespace app
