// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>

namespace app {

/// The transformation from a path's stored points to document coordinates: point * scale + offset,
/// on each axis. The identity changes no bit of any number, including -0, which is why its offset
/// is -0. Results outside the range of double become 0 or infinite and stay so.
struct Placement {
    Point scale{1, 1};
    Point offset{-0.0, -0.0};
    /// The transformed point, rounded twice on each axis; the same bits on every machine.
    Point operator()(const Point& p) const;
    /// The composition: this placement, then `next`. Composition with the identity changes nothing;
    /// otherwise the result may differ from two separate steps by a few roundings. The product of
    /// the scales can underflow or overflow even where the two separate steps would not.
    Placement then(const Placement& next) const;
    bool isIdentity() const; ///< in every bit
    /// Compares numbers, not bits: 0 equals -0, and a NaN equals nothing.
    friend bool operator==(const Placement&, const Placement&) = default;
};

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
