// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/drawing/gesture_measure.h"

#include <span>
#include <string_view>

namespace app {

/// A gesture that draws a clip window from one point to another.
struct WindowDrag {
    Point from, to;
    Numbers numbers{}; ///< as the readout shows them
    Proportion proportion = Proportion::Free;
    Anchor anchor = Anchor::Opposite;
};

/// A shape that a new clip window can have. Without `drawn` it is drawn corner by corner.
struct WindowKind {
    std::string_view key;        ///< also of its icon
    std::string_view name;       ///< to be translated, like the hints
    std::string_view hint;       ///< how it is drawn
    std::string_view hintBeside; ///< the same while there are windows
    WindowShape (*make)(const clipping::Window& box) = nullptr;
    WindowShape (*drawn)(const WindowDrag& drag) = nullptr;
    const GestureMeasure& (*measure)(Proportion proportion, Anchor anchor) = nullptr;
    Numbers (*usual)() =
        nullptr; ///< the first window's numbers, of which some are kept; may be null
};

/// Every kind, in the order of menus.
std::span<const WindowKind> windowKinds();
/// The first kind if there is none of that key.
const WindowKind& windowKind(std::string_view key);

} // namespace app
