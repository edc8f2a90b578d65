// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app {

/// Where a path's own points lie in the document: point * scale + offset, on each axis. The
/// identity changes no bit of any number, -0 included, which is why its offset is -0. Numbers
/// beyond those of double become 0 or infinite, and stay so.
struct Placement {
    Point scale{1, 1};
    Point offset{-0.0, -0.0};
    /// The point, rounded twice on each axis; the same bits on every machine.
    Point operator()(const Point& p) const;
    /// This placement and then `next`, as one. The identity before or after another changes
    /// nothing; else a few roundings may differ from those of two steps. The product of the scales
    /// can underflow or overflow where the points themselves would not in two steps.
    Placement then(const Placement& next) const;
    bool isIdentity() const; ///< bit for bit
    /// Compares numbers, not bits: 0 equals -0, and a NaN nothing.
    friend bool operator==(const Placement&, const Placement&) = default;
};

} // namespace app
