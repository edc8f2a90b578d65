// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/document/subpath.h"

#include <vector>

namespace app {

/// The dashes of a path, each an open subpath of parts of the same curves; their lengths are right
/// within the tolerance (user units, > 0). The path itself if it is solid, or if its dashes are
/// shorter than the tolerance or more than 100,000.
std::vector<Subpath> dashesOf(const Subpath& path, const Style& style, double tolerance);

} // namespace app
