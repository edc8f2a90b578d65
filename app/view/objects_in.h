// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The objects whose lines all lie in the rectangle. Visits lines only where boxes do not decide.
ObjectRanges objectsWithin(const SceneLines& lines, const clipping::Window& rectangle);

/// The objects with a line that has a point in the rectangle.
ObjectRanges objectsTouching(const SceneLines& lines, const clipping::Window& rectangle);

} // namespace app
