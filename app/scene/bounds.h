// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"

#include <optional>

namespace app {

/// What objects cover; nothing if they have no lines. It looks at the boxes of all their chunks,
/// and at the lines of those that reach farthest. For the selection there is
/// Session::selectionBounds().
std::optional<clipping::Window> boundsOf(const SceneLines& lines, const ObjectRanges& objects);

/// What all lines cover; nothing if there are none.
std::optional<clipping::Window> boundsOf(const SceneLines& lines);

} // namespace app
