// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"
#include "app/document/recipe.h"
#include "app/document/style_table.h"

#include <QString>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <variant>
#include <vector>

namespace app {

// The shapes of clip windows, in user units. Each shape is closed: it includes its border.

/// A rectangle, rotated by `angle` (radians) about its centre. It contains nothing if `min > max`
/// on an axis or a number is not finite.
struct RectangleShape {
    clipping::Window box;
    double angle = 0;
    friend bool operator==(const RectangleShape&, const RectangleShape&) = default;
};
/// What a path encloses by its fill rule; open subpaths count as closed. The recipe is the shape
/// that the path was made from, as for objects.
struct PathShape {
    Path path{};
    FillRule rule = FillRule::NonZero;
    Recipe recipe{};
    friend bool operator==(const PathShape&, const PathShape&) = default;
};
using WindowShape = std::variant<RectangleShape, PathShape>;

/// How a clip window combines with the result of the windows before it. One that replaces drops
/// that result: from here on it alone counts.
enum class WindowOperation : std::uint8_t { Add, CutOut, Intersect, Replace };
/// Which side of the clip windows is kept.
enum class Keep : std::uint8_t { Inside, Outside };

/// One clip window of a document.
struct ClipWindow {
    QString name{};
    WindowShape shape{};
    WindowOperation operation = WindowOperation::Add;
    bool visible = true;            ///< hidden windows have no effect
    std::optional<Colour> colour{}; ///< on the screen; empty: that of all windows
    friend bool operator==(const ClipWindow&, const ClipWindow&) = default;
};

/// All clip windows of a document. The visible windows are applied from first to last, starting
/// with nothing if the first one adds or replaces, else with everything. `keep` is applied last.
/// Without a visible window nothing is cut, whatever `keep` is.
struct ClipWindows {
    static constexpr std::size_t most = 1000; ///< the code that adds windows enforces it

    std::vector<ClipWindow> list{};
    Keep keep = Keep::Inside;
    friend bool operator==(const ClipWindows&, const ClipWindows&) = default;
};

/// Whether there is a visible window, so that something may be cut.
inline bool cuts(const ClipWindows& windows)
{
    return std::ranges::any_of(windows.list, &ClipWindow::visible);
}

/// The numbers of the windows that have an effect, in order: the last visible one that replaces and
/// the visible ones after it, or else all visible ones. The steps of a region are these.
std::vector<std::size_t> numbersInEffect(const ClipWindows& windows);
/// These windows alone. They keep the same, and none replaces: the first one adds instead.
ClipWindows inEffect(const ClipWindows& windows);
/// The number of the window that takes all effect from this visible one; empty: none does.
std::optional<std::size_t> replacing(const ClipWindows& windows, std::size_t number);

/// The box of a rectangle that is not rotated; empty for any other shape.
inline std::optional<clipping::Window> axisAlignedBox(const WindowShape& shape)
{
    const auto* rectangle = std::get_if<RectangleShape>(&shape);
    if (!rectangle || rectangle->angle != 0)
        return std::nullopt;
    return rectangle->box;
}

} // namespace app
