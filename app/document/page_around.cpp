// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/page_around.h"

#include "app/document/path_points.h"

#include <glm/common.hpp>

#include <optional>

namespace app {

Page pageAround(const std::vector<Shape>& shapes)
{
    Page page;
    std::optional<clipping::Window> bounds;
    const auto add = [&](const Point& p, double margin) {
        if (!bounds)
            bounds = {p - margin, p + margin};
        bounds = {glm::min(bounds->min, p - margin), glm::max(bounds->max, p + margin)};
    };
    for (const Shape& shape : shapes) {
        const double margin = shape.style.stroke ? shape.style.width / 2 : 0;
        for (const Subpath& path : shape.paths)
            forEachPoint(path, [&](const Point& point) { add(point, margin); });
    }
    if (bounds && bounds->max.x > bounds->min.x && bounds->max.y > bounds->min.y) {
        page.min = bounds->min;
        page.size = bounds->max - bounds->min;
        page.width = page.height = {100, Unit::Percent};
    }
    return page;
}

} // namespace app
