// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

// Clip windows in words.

namespace app {

/// "Rectangle", "Ellipse" …: what a window without a name is called.
QString nameOf(const WindowShape& shape);
/// The window's name, or that of its shape.
QString nameOf(const ClipWindow& window);
/// The key of the icon of a shape.
std::string_view iconOf(const WindowShape& shape);

/// "+", "−", "∩".
QString signOf(WindowOperation operation);

/// What the visible windows make together: "Old town − Market hall + Star"; "everything −
/// Market hall" if the first one does not add. Empty without a visible window.
QString resultOf(const ClipWindows& windows);

} // namespace app
