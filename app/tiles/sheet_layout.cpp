// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/sheet_layout.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double gapShare = 0.1; // of the larger side of a sheet

bool contains(const clipping::Window& window, const Point& p)
{
    return p.x >= window.min.x && p.y >= window.min.y && p.x <= window.max.x && p.y <= window.max.y;
}

} // namespace

SheetLayout layoutOf(const Tiling& tiling, double margin, SheetArrangement arrangement)
{
    const bool apart = arrangement == SheetArrangement::Apart;
    const double unit = tiling.millimetresPerUnit;
    const double gap = std::max(tiling.sheet.x, tiling.sheet.y) * gapShare;
    SheetLayout layout{arrangement, unit, {}, {}};
    for (const Tile& tile : tiling.tiles) {
        const Point size = (tile.window.max - tile.window.min) * unit;
        const Point corner =
            apart ? (tiling.sheet + gap) * Point(tile.column - 1, tile.row - 1) + margin
                  : tile.window.min * unit;
        const double around = apart ? margin : 0;
        layout.places.push_back({{corner, corner + size},
                                 {corner - around, corner + size + around},
                                 corner - tile.window.min * unit});
    }
    layout.bounds = {layout.places.front().paper.min, layout.places.back().paper.max};
    return layout;
}

std::optional<std::size_t> SheetLayout::sheetAt(const Point& layout) const
{
    for (std::size_t sheet = places.size(); sheet-- > 0;)
        if (contains(places[sheet].paper, layout))
            return sheet;
    return std::nullopt;
}

std::optional<int> SheetLayout::edgeAt(const Point& layout, double reach) const
{
    const clipping::Window outer{places.front().part.min, places.back().part.max};
    for (const auto& [part, paper, offset] : places)
        for (const int axis : {0, 1}) {
            const int along = 1 - axis;
            if (layout[along] < part.min[along] || layout[along] > part.max[along])
                continue;
            for (const double edge : {part.min[axis], part.max[axis]})
                if (std::abs(layout[axis] - edge) <= reach && edge != outer.min[axis]
                    && edge != outer.max[axis])
                    return axis;
        }
    return std::nullopt;
}

} // namespace app
