// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <vector>

namespace app::formulas {

/// A line with the window that it is clipped at.
struct Input {
    clipping::Segment segment;
    clipping::Window window;
};

/// 10,000 lines, the same at every run, in ordinary numbers (clipping/frame.h): of all sizes, with
/// ends on a small grid on which the window's edges and corners lie, through corners or a few ulps
/// beside them, points, lines along an axis; at windows with and without extent.
std::vector<Input> inputs();

} // namespace app::formulas
