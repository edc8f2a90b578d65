// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_window.h"

#include <glm/common.hpp>

#include <tuple>

namespace app {
namespace {

// The rectangle of a path whose only subpath runs along the axes through its four corners.
std::optional<clipping::Window> rectangleOf(const Path& path)
{
    if (path.subpathCount() != 1 || !path.straight() || path.pointCount() > 5)
        return std::nullopt;
    const Subpath ring = path.subpaths().front();
    std::vector<Point> corners{ring.start};
    for (const PathSegment& segment : ring.segments)
        corners.push_back(segment.to);
    if (corners.size() == 5 && corners.back() == corners.front())
        corners.pop_back();
    if (corners.size() != 4)
        return std::nullopt;
    const auto& [a, b, c, d] = std::tie(corners[0], corners[1], corners[2], corners[3]);
    const bool across = a.y == b.y && b.x == c.x && c.y == d.y && d.x == a.x;
    const bool down = a.x == b.x && b.y == c.y && c.x == d.x && d.y == a.y;
    if (!across && !down)
        return std::nullopt;
    return clipping::Window{glm::min(a, c), glm::max(a, c)};
}

} // namespace

std::optional<ClipWindow> windowOf(const ObjectView& object)
{
    const Path path = object.path();
    if (!path.hasArea())
        return std::nullopt;
    const auto& particulars = object.particulars();
    const auto* text = std::get_if<TextRecipe>(&particulars.recipe);
    const QString name = text ? text->text.section(u'\n', 0, 0) : particulars.id;
    if (const auto box = rectangleOf(path))
        return ClipWindow{name, RectangleShape{*box}};
    return ClipWindow{name, PathShape{path, object.style().fillRule, particulars.recipe}};
}

} // namespace app
