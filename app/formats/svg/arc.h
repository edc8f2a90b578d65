// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app::svg {

/// An elliptical arc as path data gives it: the rest of SVG 1.1's F.6 follows from its ends.
struct Arc {
    Point from, to;
    Point radii;           ///< of any sign and size, as in the file
    double rotation = 0;   ///< of the first radius, in degrees
    bool large = false;    ///< the longer of the two ways
    bool positive = false; ///< with growing angles ("sweep")
};

/// Appends the arc as cubic curves of at most a quarter turn each (0.03 % of the radius off at
/// most), or as a line where a radius is zero. The last one ends at `to` bit for bit; an arc
/// between equal points is nothing.
void appendArc(std::vector<PathSegment>& segments, const Arc& arc);

} // namespace app::svg
