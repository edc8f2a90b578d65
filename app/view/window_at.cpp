// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/window_at.h"

#include "app/document/window_outline.h"
#include "app/view/block_grid.h"
#include "app/view/crossings.h"

#include <algorithm>

namespace app {

bool isAt(const WindowShape& shape, const Point& point, double reach)
{
    const WindowOutline outline = outlineOf(shape, std::max(reach / 4, 1e-12));
    Crossings crossings(point);
    for (const auto& ring : outline.rings) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const clipping::Segment edge{ring[i], ring[(i + 1) % ring.size()]};
            if (distance(point, edge) <= reach)
                return true;
            crossings.add(edge);
        }
        crossings.close();
    }
    return crossings.inside(outline.rule);
}

std::optional<std::size_t> windowAt(const ClipWindows& windows, const Point& point, double reach)
{
    for (std::size_t i = windows.list.size(); i-- > 0;)
        if (windows.list[i].visible && isAt(windows.list[i].shape, point, reach))
            return i;
    return std::nullopt;
}

} // namespace app
