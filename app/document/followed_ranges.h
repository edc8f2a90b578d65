// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/splice.h"

#include <span>

namespace app {

/// The set `objects` in the numbering after the splices (ascending, in the old numbering). It
/// contains neither removed nor added objects, except where a splice removes as many as it adds:
/// these count as the same objects, changed. O(ranges + splices).
ObjectRanges followed(const ObjectRanges& objects, std::span<const Splice> splices);

} // namespace app
