// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

namespace app {

/// Names one of the clip windows: "Window 2 of 3: Main". Hidden windows count, too. Empty if it is
/// the only window, or if there is none.
QString whichText(const ClipWindows& windows, std::optional<std::size_t> number);

} // namespace app
