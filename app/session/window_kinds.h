// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

#include <span>
#include <string_view>

namespace app {

/// A shape that a new clip window can have.
struct WindowKind {
    std::string_view key;  ///< also of its icon
    std::string_view name; ///< to be translated in the context "WindowKinds"
    WindowShape (*make)(const clipping::Window& box);
};

/// Every kind, in the order of menus.
std::span<const WindowKind> windowKinds();

} // namespace app
