// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The objects with lines that all lie in the rectangle. Lines are looked at where boxes do not
/// tell.
ObjectRanges objectsWithin(const SceneLines& lines, const clipping::Window& rectangle);

/// The objects with a line that has a point in the rectangle.
ObjectRanges objectsTouching(const SceneLines& lines, const clipping::Window& rectangle);

} // namespace app
