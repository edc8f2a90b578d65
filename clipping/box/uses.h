// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

// The forms in three dimensions that the rows of the catalogue name, each from the file of its
// name. README.md, "Boxes", says what they share and how far off they are.
extern const Uses<Segment3, Window3> liangBarskyBox, cyrusBeckBox, matthesDrakopoulosBox;

} // namespace clipping
