// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

namespace app {

/// Which clip window is the one that tools move (`firstWindow`): "Window 2 of 3: Main". Hidden ones
/// are counted, too. Empty if there is no other one, or none to move.
QString whichText(const ClipWindows& windows);

} // namespace app
