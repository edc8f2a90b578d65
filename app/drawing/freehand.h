// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <span>

namespace app {

/// A freehand stroke as a path of few smooth curves: every point lies within `tolerance` (user
/// units, > 0) of it. Where the stroke turns sharply, at the scale of the tolerance, it has a corner.
/// The first and last points stay. Two points become a line. There are at least two.
Subpath smoothed(std::span<const Point> stroke, double tolerance);

} // namespace app
