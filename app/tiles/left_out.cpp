// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/left_out.h"

#include <algorithm>

namespace app {

bool isLeftOut(const TilePlan& plan, const Tiling& tiling, const Tile& tile)
{
    if (plan.leftOut.empty())
        return false;
    const auto& [left, top, right, bottom] = plan.beyond;
    const int columns = left + tiling.pageColumns() + right,
              rows = top + tiling.pageRows() + bottom;
    const int column = tile.column - tiling.beyond.left + left;
    const int row = tile.row - tiling.beyond.top + top;
    return column >= 1 && column <= columns && row >= 1 && row <= rows
           && std::ranges::count(plan.leftOut, (row - 1) * columns + column) > 0;
}

void takeAllIn(TilePlan& plan)
{
    plan.leftOut.clear();
    plan.beyond = {};
}

TilePlan toggled(const TilePlan& plan, const Tiling& tiling, const Tile& tile)
{
    TilePlan next = plan;
    next.leftOut.clear();
    for (const Tile& each : tiling.tiles) {
        const bool same = each.row == tile.row && each.column == tile.column;
        if (isLeftOut(plan, tiling, each) != same)
            next.leftOut.push_back(tiling.numberOf(each));
    }
    next.beyond = next.leftOut.empty() ? SheetsBeyond() : tiling.beyond;
    return next;
}

} // namespace app
