// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

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

} // namespace app
