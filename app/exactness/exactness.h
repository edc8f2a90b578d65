// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/exactness/exact_part.h"
#include "app/scene/scene_lines.h"

#include <array>
#include <vector>

// How exact an algorithm is for each line, against exact arithmetic.

namespace app {

/// The error of an end that an algorithm returned.
struct EndError {
    /// The larger distance from the true end on an axis, in units in the last place of the largest
    /// |coordinate| of line and window (ulps.h), the unit of the library's contract.
    double ulps = 0;
    double ownUlps = 0;   ///< the same in ulps of the coordinate itself
    bool outside = false; ///< outside the window, by however little
};

/// A wrong visibility, or an end that is not finite.
enum class Fault : std::uint8_t { None, Lost, Invented, NotFinite };

/// How exact an algorithm is for one line.
struct LineExactness {
    std::uint32_t source;           ///< index of the line among the judged segments
    Fault fault = Fault::None;      ///< NotFinite: an end is NaN or infinite
    bool orderMatters = false;      ///< swapped ends give another piece or visibility
    std::array<EndError, 2> ends{}; ///< of the returned piece; zeros if there is a fault
    double lost = 0;                ///< Lost, Invented: the larger extent of the piece, in ulps
    clipping::Segment piece{};      ///< the returned piece; for a lost line, the true piece

    bool outside() const { return ends[0].outside || ends[1].outside; }
    /// Wrong, not only inexact.
    bool isWrong() const { return fault != Fault::None || outside(); }
};

/// The unit in which errors are measured.
enum class ErrorUnit : std::uint8_t { Largest, Own };
/// The error of the worse end; infinite for a line with a fault.
double errorOf(const LineExactness& line, ErrorUnit errorUnit);

/// The results for the first `lines` lines.
struct ExactnessResults {
    clipping::Window window{};
    std::size_t lines = 0;             ///< number of lines judged so far
    std::vector<LineExactness> list{}; ///< ascending: those visible to the algorithm or in truth
};
/// Judges the lines `more`, which follow those judged so far, and adds their results.
ExactnessResults extended(ExactnessResults so, const Variant& variant,
                          std::span<const clipping::Segment> more);
/// The same for the next `count` of all lines, or as many as are left.
ExactnessResults extended(ExactnessResults so, const Variant& variant, const SceneLines& lines,
                          std::size_t count);

/// The result for one line; empty if the line is visible neither to the algorithm nor in truth.
std::optional<LineExactness> exactnessOf(const Variant& variant, const clipping::Segment& line,
                                         const clipping::Window& window);

} // namespace app
