// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/scene/scene_lines.h"

#include <optional>

namespace app {

/// The bounding box of the objects' lines; empty without lines. Visits the boxes of all their
/// chunks, and the lines of the outermost chunks. For the selection use Session::selectionBounds().
std::optional<clipping::Window> boundsOf(const SceneLines& lines, const ObjectRanges& objects);

/// The bounding box of all lines; empty without lines.
std::optional<clipping::Window> boundsOf(const SceneLines& lines);

} // namespace app
