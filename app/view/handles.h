// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <optional>
#include <span>

namespace app {

/// A handle of a rectangle: -1, 0 or 1 along x and y. (-1, -1) is its top left corner on screen,
/// (1, 0) the middle of its right side, (0, 0) the whole rectangle.
struct Handle {
    int x = 0, y = 0;
    friend bool operator==(const Handle&, const Handle&) = default;
};

/// The eight handles, the corners first.
std::span<const Handle> handles();

/// The positions of the handles on screen. If the shorter side is under 48 pixels, there are only
/// the corner handles, moved outside.
struct PlacedHandle {
    Handle handle;
    Point screen;
};
std::vector<PlacedHandle> placedHandles(const clipping::Window& rectangle, const View& view);

/// What a press at a screen point would drag: a handle within `reach` pixels on both axes (12:
/// handles accept presses in 24 x 24), the whole rectangle by its outline within 6 pixels, or
/// nothing.
std::optional<Handle> handleAt(const Point& screen, const clipping::Window& rectangle,
                               const View& view, double reach = 12);

/// The place of a handle in the drawing; of the whole rectangle: its centre.
Point placeOf(Handle handle, const clipping::Window& rectangle);

enum class Proportion : std::uint8_t { Free, Kept, Square };
enum class Anchor : std::uint8_t { Opposite, Centre };

/// `start` after `handle` was dragged by `by`. A drag beyond the opposite side flips the rectangle;
/// the result never has min > max.
clipping::Window dragged(const clipping::Window& start, Handle handle, const Point& by,
                         Proportion proportion = Proportion::Free,
                         Anchor anchor = Anchor::Opposite);

/// The rectangle between two points. Square: the longer side counts. Centre: `from` is the centre.
clipping::Window between(const Point& from, const Point& to,
                         Proportion proportion = Proportion::Free,
                         Anchor anchor = Anchor::Opposite);

} // namespace app
