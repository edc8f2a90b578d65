// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <optional>
#include <span>

namespace app {

/// What of a rectangle is being dragged: -1, 0 or 1 along x and y. (-1, -1) is its upper left
/// corner on the screen, (1, 0) the middle of its right side, (0, 0) the whole.
struct Grip {
    int x = 0, y = 0;
    friend bool operator==(const Grip&, const Grip&) = default;
};

/// The eight handles, the corners first.
std::span<const Grip> grips();

/// Where handles sit on the screen. Where the shorter side is under 48 pixels there are only the
/// corners, moved outside.
struct PlacedGrip {
    Grip grip;
    Point screen;
};
std::vector<PlacedGrip> placedGrips(const clipping::Window& rectangle, const View& view);

/// What a press at a point of the screen would drag: a handle within `reach` of it in both axes
/// (12: they accept 24 x 24), the whole by its outline within 6 pixels, or nothing.
std::optional<Grip> gripAt(const Point& screen, const clipping::Window& rectangle, const View& view,
                           double reach = 12);

enum class Proportion : std::uint8_t { Free, Kept, Square };
enum class Anchor : std::uint8_t { Opposite, Centre };

/// `start` with `grip` dragged by `by`. Dragged over the opposite side it turns over; it never has
/// min > max.
clipping::Window dragged(const clipping::Window& start, Grip grip, const Point& by,
                         Proportion proportion = Proportion::Free,
                         Anchor anchor = Anchor::Opposite);

/// The rectangle between two points; Square: as wide as high, by the larger; Centre: around `from`.
clipping::Window between(const Point& from, const Point& to,
                         Proportion proportion = Proportion::Free,
                         Anchor anchor = Anchor::Opposite);

} // namespace app
