// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/layer_report.h"

#include <algorithm>
#include <span>

namespace app {
namespace {

/// The shapes of a layer, which follow each other. (clang 14 cannot compile ranges::equal_range.)
std::span<const Shape> shapesOf(const Sheet& sheet, std::uint32_t layer)
{
    return {std::ranges::lower_bound(sheet.shapes, layer, {}, &Shape::layer),
            std::ranges::upper_bound(sheet.shapes, layer, {}, &Shape::layer)};
}

} // namespace

std::size_t linesOfLayer(const Session& session, std::uint32_t layer)
{
    const Sheet& sheet = session.sheet();
    const auto shapes = shapesOf(sheet, layer);
    const auto first = std::size_t(shapes.data() - sheet.shapes.data());
    return session.scene.firstSegmentOf(first + shapes.size())
           - session.scene.firstSegmentOf(first);
}

std::optional<Colour> inkOfLayer(const Sheet& sheet, std::uint32_t layer)
{
    for (const Shape& shape : shapesOf(sheet, layer)) {
        if (shape.style.stroke)
            return shape.style.stroke;
        if (shape.style.fill)
            return shape.style.fill;
    }
    return std::nullopt;
}

} // namespace app
