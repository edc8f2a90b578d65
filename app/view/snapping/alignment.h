// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
#include <span>
#include <vector>

namespace app {

/// A line that shows what is aligned: on axis 0 the vertical line x = `at`, on axis 1 the
/// horizontal line y = `at`. It spans both boxes.
struct AlignmentLine {
    int axis;
    double at;
    double from, to; ///< along the line
    /// The room between the two boxes, along the line; empty if they overlap there.
    std::optional<double> gapFrom{}, gapTo{};
    friend bool operator==(const AlignmentLine&, const AlignmentLine&) = default;
};

struct Alignment {
    Point by{0, 0};                     ///< the move that aligns the box
    std::vector<AlignmentLine> lines{}; ///< at most one for each axis; empty: nothing is near
};

/// Aligns edges and middles of a box with those of other boxes, on each axis with the nearest one
/// within `radius`; with the box that is nearest, if several are aligned.
Alignment align(const clipping::Window& box, std::span<const clipping::Window> others,
                double radius);

} // namespace app
