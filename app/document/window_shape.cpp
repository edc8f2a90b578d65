// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_shape.h"

#include "app/document/recipe.h"
#include "app/document/window_frame.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

namespace app {
namespace {

constexpr double roundingOfAngles = 1e-12; // relative to the lengths

clipping::Window boxOfPath(const Path& path, double tolerance)
{
    constexpr double infinite = std::numeric_limits<double>::infinity();
    clipping::Window box{Point(infinite), Point(-infinite)};
    std::vector<clipping::Segment> chords;
    appendSegments(path, tolerance, chords);
    for (const clipping::Segment& chord : chords)
        box = {glm::min(box.min, glm::min(chord.a, chord.b)),
               glm::max(box.max, glm::max(chord.a, chord.b))};
    return box;
}

// Of a path whose curves have no known size yet: its tolerance is a part of the control points'
// box.
clipping::Window boxOfPath(const Path& path)
{
    double size = 0;
    std::optional<Point> first;
    path.forEachPoint([&](const Point& p) {
        const Point apart = glm::abs(p - first.value_or(p));
        size = std::max({size, apart.x, apart.y});
        first = first.value_or(p);
    });
    return first ? boxOfPath(path, size > 0 ? size * 1e-4 : 1) : clipping::Window{};
}

bool isMove(const AffineMap& map) { return map.x == Point(1, 0) && map.y == Point(0, 1); }

// The rectangle after a map that leaves its corners right angles.
std::optional<RectangleShape> stillRectangle(const RectangleShape& rectangle, const AffineMap& map)
{
    const auto& [min, max] = rectangle.box;
    if (isMove(map))
        return RectangleShape{{map(min), map(max)}, rectangle.angle};
    const auto old = cornersOf(rectangle);
    const Point corner = map(old[0]), across = map(old[1]) - corner, down = map(old[3]) - corner;
    const double width = glm::length(across), height = glm::length(down);
    if (!(std::abs(glm::dot(across, down)) <= roundingOfAngles * width * height))
        return std::nullopt;
    if (rectangle.angle == 0 && map.placement()) {
        const Point opposite = map(old[2]);
        return RectangleShape{{glm::min(corner, opposite), glm::max(corner, opposite)}};
    }
    // A mirrored rectangle has the same points as a rotated one.
    const double angle = width > 0 ? std::atan2(across.y, across.x) : std::atan2(-down.x, down.y);
    const Point half = Point(width, height) * 0.5, centre = map(centreOf(rectangle.box));
    return RectangleShape{{centre - half, centre + half}, angle};
}

} // namespace

PathShape pathOf(const WindowShape& shape)
{
    if (const auto* path = std::get_if<PathShape>(&shape))
        return *path;
    const auto& rectangle = std::get<RectangleShape>(shape);
    const auto corners = cornersOf(rectangle);
    const Subpath ring{corners[0], {{corners[1]}, {corners[2]}, {corners[3]}}, true};
    PathShape path{Path({&ring, 1})};
    path.recipe = RectangleRecipe{rectangle.box.min, rectangle.box.max - rectangle.box.min, 0,
                                  rectangle.angle};
    return path;
}

bool isEmpty(const WindowShape& shape)
{
    const auto* path = std::get_if<PathShape>(&shape);
    return path && path->path.subpathCount() == 0;
}

WindowFrame frameOf(const WindowShape& shape)
{
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape))
        return *rectangle;
    return {boxOf(shape)};
}

clipping::Window boxOf(const WindowShape& shape)
{
    if (const auto* path = std::get_if<PathShape>(&shape))
        return boxOfPath(path->path);
    const auto corners = cornersOf(std::get<RectangleShape>(shape));
    clipping::Window box{corners[0], corners[2]};
    if (std::get<RectangleShape>(shape).angle == 0)
        return box;
    box = {corners[0], corners[0]};
    for (const Point& corner : corners)
        box = {glm::min(box.min, corner), glm::max(box.max, corner)};
    return box;
}

WindowShape mapped(const WindowShape& shape, const AffineMap& map)
{
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape))
        if (const auto still = stillRectangle(*rectangle, map))
            return *still;
    PathShape path = pathOf(shape);
    if (isMove(map)) { // at every move of the pointer, and paths may be long
        const Placement where{{1, 1}, map.to - map.from};
        path.path = path.path.placed(where);
        path.recipe = placed(path.recipe, where);
    } else {
        transform(path.path, path.recipe, map);
    }
    return path;
}

// Only rectangles are rotated, and these take the frame itself.
WindowShape fitted(const WindowShape& shape, const WindowFrame& frame)
{
    if (std::holds_alternative<RectangleShape>(shape))
        return frame;
    const auto [min, max] = boxOf(shape);
    const Point before = max - min, after = frame.box.max - frame.box.min;
    if ((before.x > 0 && !(after.x > 0)) || (before.y > 0 && !(after.y > 0)))
        return shape; // it could never be widened again
    const Point scale(before.x > 0 ? after.x / before.x : 1, before.y > 0 ? after.y / before.y : 1);
    return mapped(shape, {{scale.x, 0}, {0, scale.y}, min, frame.box.min});
}

WindowShape rotated(const WindowShape& shape, double angle)
{
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape)) {
        const double sum = std::remainder(rectangle->angle + angle, 2 * std::numbers::pi);
        const double quarters = std::round(sum / (std::numbers::pi / 2));
        if (std::abs(sum - quarters * (std::numbers::pi / 2)) > roundingOfAngles)
            return RectangleShape{rectangle->box, sum};
        if (std::fmod(quarters, 2) == 0)
            return RectangleShape{rectangle->box};
        const Point centre = centreOf(rectangle->box);
        const Point half = (rectangle->box.max - rectangle->box.min) * 0.5;
        return RectangleShape{{centre - Point(half.y, half.x), centre + Point(half.y, half.x)}};
    }
    return mapped(shape, rotation(-angle * 180 / std::numbers::pi, centreOf(boxOf(shape))));
}

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

// The window lies exactly on the path, so it must have the same corners, not only similar ones.
std::optional<RectangleShape> turnedRectangleOf(const Path& path, const Recipe& recipe)
{
    const auto* made = std::get_if<RectangleRecipe>(&recipe);
    if (!made || made->radius != 0 || made->turn == 0)
        return std::nullopt;
    const RectangleShape shape{{made->corner, made->corner + made->size}, made->turn};
    return pathOf(shape).path == path ? std::optional(shape) : std::nullopt;
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
    if (const auto turned = turnedRectangleOf(path, particulars.recipe))
        return ClipWindow{name, *turned};
    return ClipWindow{name, PathShape{path, object.style().fillRule, particulars.recipe}};
}

} // namespace app
