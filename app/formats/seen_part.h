// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

namespace app {

/// The drawing as it is seen on its page, for painters and file formats that huge numbers overtax:
/// without what is hidden and fills that have no area, and what reaches far beyond the page reduced
/// to what is near it (a stroke and a fill then become two shapes). Most drawings come back as they
/// are.
Sheet seenPart(const Sheet& sheet);

} // namespace app
