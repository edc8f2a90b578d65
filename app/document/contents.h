// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"

#include <optional>

namespace app {

/// How much there is in a drawing or a part of it. Curves count as the lines that stand for them.
struct Contents {
    std::size_t objects = 0, subpaths = 0, closedSubpaths = 0, curves = 0, lines = 0;
    double length = 0;                      ///< of all lines, in user units: what a pen draws
    std::optional<clipping::Window> bounds; ///< of the centre lines; nothing if there are none
};

/// Adds an object; `tolerance` is that of its curves, in user units.
void add(Contents& contents, const ObjectView& object, double tolerance);

/// The whole drawing, hidden or not, with the usual tolerance.
Contents contentsOf(const Document& document);

} // namespace app
