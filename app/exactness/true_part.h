// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <optional>

// The truth about a line and a window, in whole numbers of any length: every finite double is a
// whole number of some power of two. Independent of clipping/, which it judges.

namespace app {

/// An end of what is truly visible. Its coordinates are fractions, told as a double and what that
/// lacks: nearest + rest is the truth to within 2^-106 of it.
struct TrueEnd {
    glm::dvec2 nearest{}; ///< each coordinate rounded to the nearest double, to even in a tie
    glm::dvec2 rest{};    ///< truth - nearest: at most half a unit in the last place of `nearest`
    bool isNew = false;   ///< on an edge of the window; else an end of the line

    /// point - truth, off by less than a 2^-51 part of it.
    glm::dvec2 offOf(const glm::dvec2& point) const { return (point - nearest) - rest; }
};

/// What of a line is inside a closed window, in the line's direction. A contact has equal ends.
struct TruePart {
    TrueEnd a, b;
};
/// Nothing if line and window have no common point, if `min > max`, and for numbers that are not
/// finite.
std::optional<TruePart> truePart(const clipping::Segment& line, const clipping::Window& window);

/// How far a point lies to the left of a line that has a direction, in its units (y up; with y
/// down it is the right): computed without error, then rounded. All numbers are finite.
double distanceLeftOf(const clipping::Segment& line, const glm::dvec2& point);

} // namespace app
