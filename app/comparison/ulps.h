// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

// How far results for one line are apart, in the unit of the library's contract
// (clipping/algorithms/README.md, "How far off").

namespace app {

/// One unit in the last place of the largest |coordinate| of line and window.
double ulpFor(const clipping::Segment& line, const clipping::Window& window);

/// Whether a piece must begin at the line's first end, as corrected forms promise. Published forms
/// may reverse a piece.
enum class Ends : std::uint8_t { InOrder, EitherWay };

/// The largest distance on one axis between corresponding ends, in the drawing's units. Infinite if
/// a coordinate is NaN or infinite.
double endsApart(const clipping::Segment& one, const clipping::Segment& other, Ends ends);

/// The larger extent of a piece on an axis; 0 for a point, infinite as above.
double extentOf(const clipping::Segment& piece);

/// "3.5", "1,234", "8.4 × 10¹²", "∞".
QString ulpsText(double ulps);

} // namespace app
