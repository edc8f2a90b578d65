// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace app {

/// A mark on a ruler. Numbered ones are the longest.
struct Tick {
    double value; ///< in the ruler's unit
    enum class Rank : unsigned char { Numbered, Half, Fine } rank;
};

/// The marks between two values, ascending. `pixels` is the size of one unit on the screen; numbers
/// stand at least 64 pixels apart, on steps of 1, 2 or 5 times a power of ten; the finest marks at
/// least 4 pixels apart.
std::vector<Tick> ticks(double from, double to, double pixels);

} // namespace app
