// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

namespace app {

/// Where copies of `shapes` go: the first multiple of `step`, from one step on, at which none of
/// them lies on a shape of `sheet` with the same paths. After a thousand steps it gives up looking
/// (coordinates may be so large that a step changes nothing).
Point copyOffset(const Sheet& sheet, const std::vector<Shape>& shapes, const Point& step);

} // namespace app
