// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/page.h"

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

/// The origin for coordinates in a unit: the top left corner of the paper, or for user units the
/// origin of the drawing. Panels, rulers and `clip -w` all use it.
inline Point originOf(const Page& page, Unit unit)
{
    return unit == Unit::User ? Point(0) : page.min;
}

} // namespace app
