// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/window_at.h"

#include "app/document/window_outline.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace app {
namespace {

double distanceTo(const Point& p, const Point& a, const Point& b)
{
    const Point way = b - a;
    const double length = glm::dot(way, way);
    const double along = length > 0 ? std::clamp(glm::dot(p - a, way) / length, 0.0, 1.0) : 0;
    return glm::distance(p, a + way * along);
}

} // namespace

bool isAt(const WindowShape& shape, const Point& point, double reach)
{
    const WindowOutline outline = outlineOf(shape, std::max(reach / 4, 1e-12));
    int winding = 0, crossings = 0;
    for (const auto& ring : outline.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point &a = ring[i], &b = ring[(i + 1) % ring.size()];
            if (distanceTo(point, a, b) <= reach)
                return true;
            if ((a.y <= point.y) == (b.y <= point.y))
                continue;
            const double x = a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x);
            if (x > point.x) {
                ++crossings;
                winding += b.y > a.y ? 1 : -1;
            }
        }
    return outline.rule == FillRule::EvenOdd ? crossings % 2 == 1 : winding != 0;
}

std::optional<std::size_t> windowAt(const ClipWindows& windows, const Point& point, double reach)
{
    for (std::size_t i = windows.list.size(); i-- > 0;)
        if (windows.list[i].visible && isAt(windows.list[i].shape, point, reach))
            return i;
    return std::nullopt;
}

} // namespace app
