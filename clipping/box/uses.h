// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

// The form in three dimensions of the one row whose corrected function works in the plane only.
// README.md gives its error.
extern const Functions<Segment3, Window3> matthesDrakopoulosBox;

} // namespace clipping
