// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"
#include "app/tiles/tiling.h"

namespace app {

/// What is drawn in the margins of a sheet, as far as the plan wants it. Two neighbouring sheets
/// have their registration marks (a cross in a ring) at the same points of the drawing: in the
/// middle of the strip that they have in common. Corners without such a mark nearby have lines
/// along which the sheet is cut. The label below the drawing, "plan 1-2 of 2 × 3", is in letters of
/// single strokes, for plotters. It also says how large the drawing is on all sheets together.
std::vector<Object> marksOf(const Tiling& tiling, const Tile& tile, const TilePlan& plan,
                            const QString& title);

} // namespace app
