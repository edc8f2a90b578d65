// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>
#include <vector>

namespace app {

/// The polyline reduced to few of its points, such that every point lies within `tolerance` of it
/// (Ramer 1972, Douglas and Peucker 1973). The first and last points stay.
std::vector<Point> simplified(std::span<const Point> polyline, double tolerance);

} // namespace app
