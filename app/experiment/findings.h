// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <span>

namespace app {

/// What a variant says is visible, and how far that is true.
struct Findings {
    std::uint64_t visible = 0; ///< lines
    std::uint64_t lost = 0;    ///< lines that are truly visible and that it drops
    std::uint64_t shown = 0;   ///< lines that are truly not visible and that it keeps
    /// Of the visible lines, whichever end comes first, with their ends rounded to some 2^-16 of
    /// the window's largest |coordinate|: variants that agree have the same (a rounding error
    /// that lies across a step is not to be expected below a hundred million lines).
    std::uint64_t checksum = 0;

    friend bool operator==(const Findings&, const Findings&) = default;
};

/// Adds what was found in one block, whose first line is number `first` of the scene. `truth` is
/// what is truly visible; both are in the order of the lines.
Findings added(Findings so, std::span<const clipping::Clipped> found,
               std::span<const clipping::Clipped> truth, const clipping::Window& window,
               std::uint64_t first);

} // namespace app
