// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/view.h"

#include <glm/common.hpp>

#include <algorithm>

namespace app {

constexpr double leastZoom = 1e-9, mostZoom = 1e9;

void View::zoomAt(const Point& screen, double factor)
{
    const Point anchor = toDrawing(screen);
    zoom = std::clamp(zoom * factor, leastZoom, mostZoom);
    centre = anchor - (screen - size * 0.5) / zoom;
}

void View::fit(const clipping::Window& rectangle, double margin)
{
    const glm::dvec2 extent = rectangle.max - rectangle.min;
    const glm::dvec2 room = glm::max(size - 2 * margin, glm::dvec2(1));
    const double x = extent.x > 0 ? room.x / extent.x : mostZoom;
    const double y = extent.y > 0 ? room.y / extent.y : mostZoom;
    if (extent.x > 0 || extent.y > 0)
        zoom = std::clamp(std::min(x, y), leastZoom, mostZoom);
    centre = rectangle.min + extent * 0.5;
}

} // namespace app
