// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace app {

// The shapes that a clip window can have, in user units. Each is closed: its border belongs to it.

/// A rectangle, turned by `angle` (radians) about its centre. One with `min > max` on an axis or
/// with a number that is not finite contains nothing.
struct RectangleShape {
    clipping::Window box;
    double angle = 0;
    friend bool operator==(const RectangleShape&, const RectangleShape&) = default;
};
struct PolygonShape {
    std::vector<glm::dvec2> corners; ///< in order
    friend bool operator==(const PolygonShape&, const PolygonShape&) = default;
};
using WindowShape = std::variant<RectangleShape, PolygonShape>;

/// What a clip window does with what the windows before it leave.
enum class WindowOperation : std::uint8_t { Add, CutOut, Intersect };
/// Which side of the clip windows is kept.
enum class Keep : std::uint8_t { Inside, Outside };

/// One clip window of a document.
struct ClipWindow {
    QString name{};
    WindowShape shape{};
    WindowOperation operation = WindowOperation::Add;
    bool visible = true; ///< a hidden one does nothing
    friend bool operator==(const ClipWindow&, const ClipWindow&) = default;
};

/// All clip windows of a document. The visible ones are applied from the first to the last: to
/// nothing if the first of them adds, else to everything. `keep` comes last. Without a visible
/// window nothing is cut, whatever `keep` says.
struct ClipWindows {
    static constexpr std::size_t most = 1000; ///< what makes lists keeps to it

    std::vector<ClipWindow> list{};
    Keep keep = Keep::Inside;
    friend bool operator==(const ClipWindows&, const ClipWindows&) = default;
};

/// The box of a rectangle that is not turned; nothing for any other shape.
inline std::optional<clipping::Window> axisAlignedBox(const WindowShape& shape)
{
    const auto* rectangle = std::get_if<RectangleShape>(&shape);
    if (!rectangle || rectangle->angle != 0)
        return std::nullopt;
    return rectangle->box;
}

} // namespace app
