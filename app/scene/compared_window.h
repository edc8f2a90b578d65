// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"

namespace app {

/// The rectangle at which algorithms are compared, raced and explained.
struct ComparedWindow {
    clipping::Window window;
    bool isPage = false; ///< true: no such clip window exists, `window` is the page
    friend bool operator==(const ComparedWindow&, const ComparedWindow&) = default;
};

/// The clip window that tools move and resize and panels show: the first visible axis-aligned
/// rectangle, if any.
std::optional<clipping::Window> firstWindow(const ClipWindows& windows);
/// Moves that clip window to `window`. Without one it adds a clip window, unless there are already
/// `ClipWindows::most`.
ClipWindows withWindow(ClipWindows windows, const clipping::Window& window);
/// Removes that clip window.
ClipWindows withoutWindow(ClipWindows windows);

/// The first visible axis-aligned rectangle, regardless of its operation; otherwise the page.
ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page);

} // namespace app
