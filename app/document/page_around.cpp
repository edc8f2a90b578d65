// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/page_around.h"

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
        for (const Path& path : shape.paths) {
            add(path.start, margin);
            for (const Stretch& stretch : path.stretches) {
                add(stretch.to, margin);
                if (stretch.curved) {
                    add(stretch.control1, margin);
                    add(stretch.control2, margin);
                }
            }
        }
    }
    if (bounds && bounds->max.x > bounds->min.x && bounds->max.y > bounds->min.y) {
        page.min = bounds->min;
        page.size = bounds->max - bounds->min;
        page.width = page.height = {100, Unit::Percent};
    }
    return page;
}

} // namespace app
