// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"
#include "app/exactness/true_part.h"
#include "app/scene/scene_lines.h"

#include <array>
#include <vector>

// How right an algorithm is about each line, against exact arithmetic.

namespace app {

/// Of an end that an algorithm returned, against the true one.
struct EndTruth {
    /// The distance on the worse axis, in units in the last place of the largest |coordinate| of
    /// line and window (ulps.h), as the library's contract counts.
    double ulps = 0;
    double ownUlps = 0;   ///< the same in units of that coordinate itself
    bool outside = false; ///< of the window, by however little
};

/// What is wrong with whether the line is visible.
enum class Fault : std::uint8_t { None, Lost, Invented, NotFinite };

/// What an algorithm does with one line.
struct LineTruth {
    std::uint32_t source;           ///< the line: an index into the segments that were judged
    Fault fault = Fault::None;      ///< NotFinite: an end is no number
    bool orderMatters = false;      ///< from its other end the line is cut elsewhere, or not seen
    std::array<EndTruth, 2> ends{}; ///< of the piece that was returned; nothing if there is a fault
    double lost = 0;                ///< Lost, Invented: the larger extent of the piece, in ulps
    clipping::Segment piece{};      ///< what was returned, or of a line that is lost what is true

    bool outside() const { return ends[0].outside || ends[1].outside; }
    /// Not only inexact.
    bool isWrong() const { return fault != Fault::None || outside(); }
};

/// In what errors are measured.
enum class Yardstick : std::uint8_t { Largest, Own };
/// Of the worse end; of a line with a fault infinite.
double errorOf(const LineTruth& line, Yardstick yardstick);

/// What was found among some lines.
struct Truths {
    clipping::Window window{};
    std::size_t lines = 0;         ///< that were judged
    std::vector<LineTruth> list{}; ///< ascending by line: those of which anybody sees something
};
/// Judges these lines too, which come after those that were judged.
Truths extended(Truths so, const Variant& variant, std::span<const clipping::Segment> more);
/// The same with the next `count` of all lines, or as many as there are.
Truths extended(Truths so, const Variant& variant, const SceneLines& lines, std::size_t count);

/// Of one line; empty if nothing of it is visible.
std::optional<LineTruth> truthOf(const Variant& variant, const clipping::Segment& line,
                                 const clipping::Window& window);

} // namespace app
