// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"

namespace app {

/// The rectangle at which algorithms are compared, raced and explained.
struct ComparedWindow {
    clipping::Window window;
    bool isPage = false;                 ///< true: no such clip window exists, `window` is the page
    std::optional<std::size_t> number{}; ///< of that clip window
    /// Whether results there are those of the drawing: not at the page of a drawing that is cut at
    /// other clip windows.
    bool comparable = true;

    /// Where algorithms are compared; empty: nowhere.
    std::optional<clipping::Window> place() const
    {
        return comparable ? std::optional(window) : std::nullopt;
    }
    friend bool operator==(const ComparedWindow&, const ComparedWindow&) = default;
};

/// The number of the clip window that tools and panels act on: the chosen one if it is visible,
/// else the first one that has an effect, if any.
std::optional<std::size_t> actedOn(const ClipWindows& windows, std::size_t chosen);

/// The window with the number `first` if it is an axis-aligned rectangle and has an effect, else
/// the first one that is and has, regardless of its operation; otherwise the page.
ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page,
                              std::optional<std::size_t> first = {});

} // namespace app
