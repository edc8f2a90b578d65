// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithms/lines_and_rays/uses.h"

namespace clipping {

// The functions that clip.h takes (`algorithmFor`), without the rest of the catalogue. Each is
// defined in its algorithm's file.
extern const Functions<Segment, Window> exactWindow;
extern const Functions<BasicSegment<float>, BasicWindow<float>> exactFloats;
extern const Functions<Segment3, Window3> liangBarskyBox;

} // namespace clipping
