// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"

#include <optional>

namespace app {

/// Whether the shape contains the point or its border is no farther than `reach` (user units).
bool isAt(const WindowShape& shape, const Point& point, double reach);

/// The number of the last visible clip window there: it lies above those before it.
std::optional<std::size_t> windowAt(const ClipWindows& windows, const Point& point, double reach);

} // namespace app
