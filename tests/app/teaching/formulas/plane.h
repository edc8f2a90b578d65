// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <array>

namespace app::formulas {

/// The plane as a pseudo-code has turned or mirrored it: each of its axes is one of the picture's,
/// or its negative.
struct Plane {
    std::array<int, 2> axes{0, 1};
    std::array<bool, 2> isNegative{false, false};

    /// The ends of a segment of the picture: x, y, x, y.
    std::array<double, 4> of(const clipping::Segment& s) const;
    /// An edge of the picture's window.
    clipping::Edge of(clipping::Edge edge) const;
};

} // namespace app::formulas
