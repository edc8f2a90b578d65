// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

// Limits of a drawing; beyond them the reader refuses the file with one sentence. They are far
// above the needs of real drawings, and low enough that the worst small file ends within seconds.

namespace app::dxf {

constexpr std::size_t mostBytes = 500'000'000; ///< read from a pipe, which may never end
constexpr int deepestInsert = 50;              ///< blocks within blocks
/// Shapes and chords together; in a file with more bytes than this, one for each byte.
constexpr std::size_t mostParts = 10'000'000;
/// Pairs of code and value that are read again because their blocks are inserted.
constexpr std::size_t mostRepeatedPairs = 50'000'000;
constexpr std::size_t pairsOfInsert = 16;         ///< what an insertion counts, beside its block
constexpr std::size_t mostDashes = 100;           ///< of one line type
constexpr std::size_t mostSplinePoints = 100'000; ///< knots, or control points, of one spline
constexpr int highestDegree = 25;                 ///< of a spline
constexpr double splineTolerance = 0.001;         ///< millimetres
constexpr double largestCoordinate = 1e100;       ///< keeps products finite
/// File bytes that need as much memory as one of them takes in a drawing, at most.
constexpr std::size_t memoryOfByte = 4;

} // namespace app::dxf
