// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

// How far answers about one line are apart, in the unit of the library's contract
// (clipping/README.md, "How far off").

namespace app {

/// One unit in the last place of the largest |coordinate| of line and window.
double ulpFor(const clipping::Segment& line, const clipping::Window& window);

/// Whether a piece must begin where the line does: the contract of corrected forms. Published ones
/// may turn it round.
enum class Ends : std::uint8_t { InOrder, EitherWay };

/// The larger distance on an axis between two ends that belong together, in the drawing's units.
/// Infinite if anything is not a number.
double endsApart(const clipping::Segment& one, const clipping::Segment& other, Ends ends);

/// Of a piece: its larger extent on an axis; 0 for a point, infinite as above.
double extentOf(const clipping::Segment& piece);

/// "3.5", "1,234", "8.4 × 10¹²", "∞".
QString ulpsText(double ulps);

} // namespace app
