// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace app {

/// A mark on a ruler. Marks with numbers are the longest.
struct Tick {
    double value; ///< in the ruler's unit
    enum class Rank : unsigned char { Numbered, Half, Fine } rank;
};

/// The marks between two values, ascending. `pixels` is the size of one unit on screen. Numbers are
/// at least 64 pixels apart, at multiples of 1, 2 or 5 times a power of ten; the finest marks are
/// at least 4 pixels apart.
std::vector<Tick> ticks(double from, double to, double pixels);

} // namespace app
