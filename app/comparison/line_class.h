// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

} // namespace app
