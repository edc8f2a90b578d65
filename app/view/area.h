// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>
#include <vector>

namespace app {

/// The part of a closed outline's area inside the window, as an outline that may run along the
/// window's edges (Sutherland and Hodgman 1974). It can be filled with either fill rule.
std::vector<Point> areaInside(std::span<const Point> outline, const clipping::Window& window);

} // namespace app
