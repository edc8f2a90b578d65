// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <span>
#include <vector>

namespace app {

/// The polyline with as few of its points as keep every one within `tolerance` of it (Ramer 1972,
/// Douglas and Peucker 1973). First and last stay.
std::vector<Point> simplified(std::span<const Point> polyline, double tolerance);

} // namespace app
