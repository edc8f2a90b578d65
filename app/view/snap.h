// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <optional>
#include <span>

namespace app {

/// The targets that the pointer snaps to.
enum class SnapTo : std::uint8_t { Nothing = 0, Ends = 1, Middles = 2, WindowEdges = 4, All = 7 };
constexpr bool operator&(SnapTo a, SnapTo b) { return (std::uint8_t(a) & std::uint8_t(b)) != 0; }

struct Snap {
    Point point;
    SnapTo what; ///< a single target
    friend bool operator==(const Snap&, const Snap&) = default;
};

/// The nearest end or middle of `segments` within `radius` of the pointer; otherwise the nearest
/// edge of the window (its corner, if two edges are near). The window is optional.
std::optional<Snap> snap(const Point& pointer, double radius,
                         std::span<const clipping::Segment> segments,
                         const std::optional<clipping::Window>& window, SnapTo to);

} // namespace app
