// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/traced_line.h"
#include "clipping/geometry.h"

#include <QString>

#include <array>

namespace app {

/// The class of a line. Inside: both ends are in the window. Rejected: both ends are beyond the
/// same edge. Cut: any other line with a visible part. Missed: any other line, with no
/// visible part.
enum class LineClass : std::uint8_t { Inside, Rejected, Cut, Missed };

/// All classes, in the order of every table and chart.
inline constexpr std::array lineClasses{LineClass::Inside, LineClass::Rejected, LineClass::Cut,
                                        LineClass::Missed};

/// `visible`: whether a part of the line is visible.
LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window, bool visible);

/// The same, with the exact answer to whether a part is visible.
LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window);

/// "wholly inside", "rejected at once", "cut", "misses the window".
QString classText(LineClass lineClass);

/// An outcode as it is written everywhere, one digit for each bit of outcodeBits(): "1001". The
/// bits compare coordinates, so an outcode is the same in a drawing, where y grows downward, and in
/// a figure, where y grows upward. Words such as "above" say what is seen on screen.
QString outcodeText(unsigned code);

/// The region of an outcode, as seen on screen: "inside", "left", "above right".
QString regionText(unsigned code, YAxis y);

/// The meaning of the four bits, in their order; the pages define the bits with the same words.
QString outcodeBits();

} // namespace app
