// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"

namespace clipping {

// The forms for infinite lines and rays that the rows of the catalogue name. Each is defined in its
// algorithm's file in this folder.
extern const Functions<Line, Window, Segment> cyrusBeckLine, liangBarskyLine,
    matthesDrakopoulosLine, skalaLine;
extern const Functions<Ray, Window, Segment> cyrusBeckRay, liangBarskyRay, matthesDrakopoulosRay,
    skalaRay;

} // namespace clipping
