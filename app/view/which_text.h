// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

namespace app {

/// Names the clip window that tools act on (`firstWindow`): "Window 2 of 3: Main". Hidden windows
/// count, too. Empty if it is the only window, or if there is no such window.
QString whichText(const ClipWindows& windows);

} // namespace app
