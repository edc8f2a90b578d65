// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/document/subpath.h"

#include <vector>

namespace app {

/// The parts of a stroke of a width > 0 without its dashes, as SVG draws it, with curves off by at
/// most the tolerance (user units, > 0): beside each line and curve, at its joins
/// and its caps. Each is a closed ring in the same direction, so that the winding number is not 0
/// where the stroke is, and 0 elsewhere. Rings beside each other share their ends bit for bit. A
/// point has only caps.
std::vector<Subpath> strokeRings(const Subpath& path, const Style& style, double tolerance);

} // namespace app
