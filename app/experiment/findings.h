// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>

namespace app {

/// What a variant finds visible, and how much of that is correct.
struct Findings {
    std::uint64_t visible = 0; ///< lines
    std::uint64_t lost = 0;    ///< visible lines that it drops
    std::uint64_t shown = 0;   ///< invisible lines that it keeps
    /// Of the visible lines, independent of the order of ends, with coordinates rounded to about
    /// 2^-16 of the window's largest |coordinate|, so that variants that agree have the same
    /// checksum (a rounding error across a step is not to be expected below a hundred million
    /// lines).
    std::uint64_t checksum = 0;

    friend bool operator==(const Findings&, const Findings&) = default;
};

/// Adds the findings of one block, whose first line is number `first` of the scene. `exactPieces`
/// is what is truly visible; both are in the order of the lines.
Findings added(Findings so, std::span<const clipping::Clipped> found,
               std::span<const clipping::Clipped> exactPieces, const clipping::Window& window,
               std::uint64_t first);

} // namespace app
