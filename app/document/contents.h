// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/document/objects.h"

#include <optional>

namespace app {

/// The amount of content in a drawing or in a part of it. Each curve counts as the lines that
/// approximate it.
struct Contents {
    std::size_t objects = 0, subpaths = 0, closedSubpaths = 0, curves = 0, lines = 0;
    double length = 0;                      ///< of all lines, in user units: what a pen draws
    std::optional<clipping::Window> bounds; ///< of the centre lines; empty without lines
};

/// Adds an object; `tolerance` is the flattening tolerance in user units.
void add(Contents& contents, const ObjectView& object, double tolerance);

/// The contents of the whole drawing, including hidden objects, with the usual tolerance.
Contents contentsOf(const Document& document);

/// A page around all points and half the stroke widths, with a user unit of one pixel, for drawings
/// without a page; the usual page if there are no objects.
Page pageAround(const Objects& objects);

} // namespace app
