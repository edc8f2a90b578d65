// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/tiles/tiling.h"

// The sheets that a person leaves out, by their numbers in a plan.

namespace app {

/// Whether a person has left out the sheet. The plan may be one for a drawing that needed other
/// sheets beyond the page.
bool isLeftOut(const TilePlan& plan, const Tiling& tiling, const Tile& tile);
/// Leaves out the sheet, or takes it in again. Sheets that are left out, but not in the tiling, are
/// forgotten.
TilePlan toggled(const TilePlan& plan, const Tiling& tiling, const Tile& tile);

void takeAllIn(TilePlan& plan);

} // namespace app
