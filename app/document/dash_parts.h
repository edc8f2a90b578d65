// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace app {

/// The part of a line of a polyline that a dash covers.
struct DashPart {
    std::size_t line;
    double from, to; ///< shares of the way along the line
    bool begins;     ///< whether the dash begins here, or goes on from the line before
};

/// The dashes of a polyline whose lines have these lengths, in order. `pattern` is dash, gap, dash,
/// gap … (a pattern of odd length is repeated, as in SVG); `phase` is the offset into the pattern
/// at the start of the polyline. Empty if the line is solid: the pattern is empty, not positive or
/// shorter than `shortest`.
std::optional<std::vector<DashPart>> dashParts(std::span<const double> lengths,
                                               std::span<const double> pattern, double phase,
                                               double shortest);

} // namespace app
