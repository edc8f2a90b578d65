// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_ranges.h"
#include "app/document/splice.h"

#include <span>

namespace app {

/// The same objects after the splices (ascending, numbered as before them): those that went are not
/// in it, nor are those that came; where as many came as went, they are the same ones, changed.
/// O(ranges + splices).
ObjectRanges followed(const ObjectRanges& objects, std::span<const Splice> splices);

} // namespace app
