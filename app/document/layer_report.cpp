// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/layer_report.h"

#include <algorithm>

namespace app {

std::size_t linesOfLayer(const Session& session, std::uint32_t layer)
{
    const auto& shapes = session.sheet().shapes;
    const auto range = std::ranges::equal_range(shapes, layer, {}, &Shape::layer);
    const auto index = [&](auto at) { return std::size_t(at - shapes.begin()); };
    return session.scene.firstSegmentOf(index(range.end()))
           - session.scene.firstSegmentOf(index(range.begin()));
}

std::optional<Colour> inkOfLayer(const Sheet& sheet, std::uint32_t layer)
{
    for (const Shape& shape : std::ranges::equal_range(sheet.shapes, layer, {}, &Shape::layer)) {
        if (shape.style.stroke)
            return shape.style.stroke;
        if (shape.style.fill)
            return shape.style.fill;
    }
    return std::nullopt;
}

} // namespace app
