// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/tiles/tiling.h"

namespace app {

/// Leaves out the sheets without any part of these objects, if the plan wants it. `lines` are all
/// visible lines of `objects`. Pieces shorter than `leastLength` (user units) do not count, as a
/// cut drops them. A sheet inside a filled area is not empty.
Tiling withoutEmptySheets(Tiling tiling, const TilePlan& plan, const SceneLines& lines,
                          const Objects& objects, double leastLength);

/// "2 empty sheets were left out." Empty text if there are none.
QString emptySheetsText(const Tiling& tiling);

} // namespace app
