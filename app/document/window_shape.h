// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/affine_map.h"
#include "app/document/clip_windows.h"
#include "app/document/object_view.h"
#include "app/document/window_frame.h"

#include <optional>

namespace app {

// The shape of a clip window as something that is moved, resized and rotated.

/// A rectangle is its own frame; that of a path is its bounding box. Flattens a path's curves.
WindowFrame frameOf(const WindowShape& shape);

/// The shape as a path. Only a rectangle that is not rotated keeps a recipe.
PathShape pathOf(const WindowShape& shape);
/// Whether it is a path without points.
bool isEmpty(const WindowShape& shape);
/// The bounding box along the axes; of an empty path the origin. Flattens a path's curves.
clipping::Window boxOf(const WindowShape& shape);

/// A rectangle stays one if it is moved, rotated, or scaled along its sides; otherwise it becomes a
/// path.
WindowShape mapped(const WindowShape& shape, const AffineMap& map);

/// The shape, stretched so that its frame becomes `frame`, which has the same angle. A side of
/// length zero is only moved; a path is not squeezed to one.
WindowShape fitted(const WindowShape& shape, const WindowFrame& frame);

/// The shape, rotated about the centre of its frame (radians, from x towards y). A rectangle that
/// is rotated by a multiple of 90° has the angle 0.
WindowShape rotated(const WindowShape& shape, double angle);

/// The clip window with the shape, the fill rule and the id of an object, or the first line of a
/// text, as its name; empty if the object encloses nothing, such as a single line.
std::optional<ClipWindow> windowOf(const ObjectView& object);

} // namespace app
