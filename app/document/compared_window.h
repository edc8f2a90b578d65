// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/sheet.h"

namespace app {

/// The one rectangle at which algorithms are compared, raced and explained.
struct ComparedWindow {
    clipping::Window window;
    bool isPage = false; ///< there is no such clip window: it is the page
    friend bool operator==(const ComparedWindow&, const ComparedWindow&) = default;
};

/// The first visible axis-aligned rectangle, whatever its operation; else the page.
ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page);

} // namespace app
