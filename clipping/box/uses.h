// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

// The form in three dimensions of the one row whose corrected function is for the plane alone.
// README.md, "Boxes", says how far off it is.
extern const Uses<Segment3, Window3> matthesDrakopoulosBox;

} // namespace clipping
