// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"

namespace app {

/// The one rectangle at which algorithms are compared, raced and explained.
struct ComparedWindow {
    clipping::Window window;
    bool isPage = false; ///< there is no such clip window: it is the page
    friend bool operator==(const ComparedWindow&, const ComparedWindow&) = default;
};

/// The clip window that tools move and size, and that numbers are shown of: the first visible
/// axis-aligned rectangle, if there is one.
std::optional<clipping::Window> firstWindow(const ClipWindows& windows);
/// With that one in another place; with one more if there is none, unless there are
/// `ClipWindows::most` already.
ClipWindows withWindow(ClipWindows windows, const clipping::Window& window);
/// Without that one.
ClipWindows withoutWindow(ClipWindows windows);

/// The first visible axis-aligned rectangle, whatever its operation; else the page.
ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page);

} // namespace app
