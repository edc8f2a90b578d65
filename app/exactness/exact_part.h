// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <optional>

// The exact intersection of a line and a window, in integers of any length: every finite double is
// an integer times a power of two. Independent of clipping/, whose results it checks.

namespace app {

/// An end of the exact visible part. Its coordinates are fractions, given as a double and a
/// remainder: nearest + rest is the exact value to a relative error of 2^-106.
struct ExactEnd {
    glm::dvec2 nearest{}; ///< each coordinate rounded to the nearest double, to even in a tie
    glm::dvec2 rest{};    ///< exact value - nearest: at most half an ulp of `nearest`
    bool isNew = false;   ///< on an edge of the window; else an end of the line

    /// point - exact value, with a relative error below 2^-51.
    glm::dvec2 offOf(const glm::dvec2& point) const { return (point - nearest) - rest; }
};

/// The part of a line inside a closed window, in the line's direction. A contact has equal ends.
struct ExactPart {
    ExactEnd a, b;
};
/// Empty if line and window have no common point, if `min > max`, or if a number is not finite.
std::optional<ExactPart> exactPart(const clipping::Segment& line, const clipping::Window& window);

/// The distance of a point to the left of a directed line, in the line's units (y up; with y down,
/// to the right): computed exactly, then rounded. All numbers are finite.
double distanceLeftOf(const clipping::Segment& line, const glm::dvec2& point);

} // namespace app
