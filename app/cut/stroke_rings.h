// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "app/document/subpath.h"

#include <vector>

namespace app {

/// How a stroke is drawn. Lengths are in user units.
struct StrokePen {
    double width; ///< > 0
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    double miterLimit = 4;
    double tolerance; ///< how far curves may be off, > 0
};

/// The parts of a stroke without dashes, as SVG draws it: beside each line and curve, at its joins
/// and its caps. Each is a closed ring in the same direction, so that the winding number is not 0
/// where the stroke is, and 0 elsewhere. Rings beside each other share their ends bit for bit. A
/// point has only caps.
std::vector<Subpath> strokeRings(const Subpath& path, const StrokePen& pen);

} // namespace app
