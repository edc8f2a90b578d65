// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/document/subpath.h"

#include <span>

namespace app::svg {

/// A point that stands for a part of an area or a line, which is `weight` large or long.
struct SpreadPoint {
    Point at;
    double weight = 0;
};

/// About rows² points or fewer, spread evenly over the area that the paths fill. The curves may be
/// off by a hundredth of the size.
std::vector<SpreadPoint> pointsInside(std::span<const Subpath> paths, FillRule rule, int rows);

/// The same along the paths.
std::vector<SpreadPoint> pointsAlong(std::span<const Subpath> paths, int rows);

} // namespace app::svg
