// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/page.h"

#include <span>

namespace app {

/// The union of the shapes of several windows, whatever their operations, as one path of straight
/// lines: curves are replaced within 0.01 mm on paper. Decided exactly (clipping/area).
PathShape united(std::span<const ClipWindow> windows, const Page& page);

} // namespace app
