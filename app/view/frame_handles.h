// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/window_shape.h"
#include "app/view/handles.h"

// The handles of a clip window: those of its frame, which may be rotated, and one that rotates it.

namespace app {

/// Above the middle of the upper side.
inline constexpr Handle rotationHandle{0, -2};
constexpr double rotationHandleAbove = 28; ///< pixels

/// A point on screen, as if the frame were not rotated; and back.
Point unrotated(const WindowFrame& frame, const View& view, const Point& screen);
Point rotated(const WindowFrame& frame, const View& view, const Point& screen);

/// The place of the handle that rotates, on screen.
Point placeOfRotation(const WindowFrame& frame, const View& view);

std::vector<PlacedHandle> placedHandles(const WindowFrame& frame, const View& view);

/// As for a rectangle, and the handle that rotates.
std::optional<Handle> handleAt(const Point& screen, const WindowFrame& frame, const View& view);

/// The frame after a handle was dragged from one point of the drawing to another. Proportion::Kept
/// rotates by steps of 15°.
WindowFrame dragged(const WindowFrame& start, Handle handle, const Point& from, const Point& to,
                    Proportion proportion, Anchor anchor);

} // namespace app
