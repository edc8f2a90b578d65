// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

namespace app::svg {

/// An elliptical arc in the parameters of path data. SVG 1.1, F.6, derives its centre.
struct Arc {
    Point from, to;
    Point radii;           ///< any sign and size, as in the file
    double rotation = 0;   ///< rotation of the first radius, in degrees
    bool large = false;    ///< the longer of the two arcs
    bool positive = false; ///< towards growing angles ("sweep")
};

/// Appends the arc as cubic curves of at most a quarter turn each (error at most 0.03 % of the
/// radius), or as a line if a radius is zero. The last curve ends at `to` bit for bit. An arc
/// between equal points appends nothing.
void appendArc(std::vector<PathSegment>& segments, const Arc& arc);

} // namespace app::svg
