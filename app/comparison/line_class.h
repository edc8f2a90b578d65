// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <array>

namespace app {

/// What can be said of a line before any arithmetic, and what came of it. Rejected: both ends are
/// beyond one side of the window. Missed: they are not, and yet nothing is visible.
enum class LineClass : std::uint8_t { Inside, Rejected, Cut, Missed };

/// All of them, in the order of every table and chart.
inline constexpr std::array lineClasses{LineClass::Inside, LineClass::Rejected, LineClass::Cut,
                                        LineClass::Missed};

/// Of a line of which a part is visible, or not.
LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window, bool visible);

/// By what is truly visible.
LineClass lineClassOf(const clipping::Segment& line, const clipping::Window& window);

/// "wholly inside", "rejected at once", "cut", "misses the window".
QString words(LineClass lineClass);

} // namespace app
