// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/teaching.h"

#include <string_view>

// How a step at a convex polygon is described. Edges are numbered from 1, from corner to corner.

namespace app {

/// The pseudo-code of a row's form for convex polygons, with labels (clipping/pseudo_code.h); a row
/// without its own has that of its form for windows.
std::string_view polygonCode(const Variant& variant);
/// The sentence of a step, with the numbers of edges; never empty.
QString polygonSentence(const SentenceContext& context);

/// The number of the edge that a step concerns; 0: none.
std::size_t polygonEdgeOf(const SentenceContext& context);

} // namespace app
