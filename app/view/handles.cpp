// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/handles.h"

#include <glm/common.hpp>

#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double small = 48, outside = 6, outline = 6; // pixels

clipping::Window ordered(const Point& a, const Point& b)
{
    return {glm::min(a, b), glm::max(a, b)};
}

} // namespace

std::span<const Handle> handles()
{
    static constexpr std::array<Handle, 8> all{
        {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}}};
    return all;
}

Point placeOf(Handle handle, const clipping::Window& rectangle)
{
    const auto along = [](int side, double min, double max) {
        return side < 0 ? min : side > 0 ? max : min + (max - min) * 0.5;
    };
    return {along(handle.x, rectangle.min.x, rectangle.max.x),
            along(handle.y, rectangle.min.y, rectangle.max.y)};
}

std::vector<PlacedHandle> placedHandles(const clipping::Window& rectangle, const View& view)
{
    const Point min = view.toScreen(rectangle.min), max = view.toScreen(rectangle.max);
    const Point centre = (min + max) * 0.5, half = (max - min) * 0.5;
    const bool cramped = 2 * std::min(half.x, half.y) < small;
    std::vector<PlacedHandle> placed;
    for (const Handle handle : handles().first(cramped ? 4 : 8)) {
        const Point direction(handle.x, handle.y);
        placed.push_back({handle, centre + direction * (half + (cramped ? outside : 0.0))});
    }
    return placed;
}

std::optional<Handle> handleAt(const Point& screen, const clipping::Window& rectangle,
                               const View& view, double reach)
{
    for (const PlacedHandle& placed : placedHandles(rectangle, view)) {
        const Point away = glm::abs(screen - placed.screen);
        if (away.x <= reach && away.y <= reach)
            return placed.handle;
    }
    const Point min = view.toScreen(rectangle.min), max = view.toScreen(rectangle.max);
    const Point past = glm::max(min - screen, screen - max); // positive: outside the rectangle
    const double most = std::max(past.x, past.y);
    return std::abs(most) <= outline ? std::optional(Handle{}) : std::nullopt;
}

clipping::Window dragged(const clipping::Window& start, Handle handle, const Point& by,
                         Proportion proportion, Anchor anchor)
{
    if (handle == Handle{})
        return {start.min + by, start.max + by};
    const Point direction(handle.x, handle.y), centre = start.min + (start.max - start.min) * 0.5;
    const double share = anchor == Anchor::Centre ? 2 : 1;
    const Point old = start.max - start.min;
    Point size = old + direction * by * share; // negative if the rectangle is flipped
    if (proportion != Proportion::Free) {
        const Point shape =
            proportion == Proportion::Square || old.x <= 0 || old.y <= 0 ? Point(1) : old;
        const Point ratio = size / shape;
        double scale = std::abs(ratio.x) > std::abs(ratio.y) ? ratio.x : ratio.y;
        if (handle.x == 0 || handle.y == 0)
            scale = handle.x == 0 ? ratio.y : ratio.x;
        size = shape * Point(std::copysign(scale, ratio.x), std::copysign(scale, ratio.y));
    }
    const Point fixed = anchor == Anchor::Centre ? centre : centre - direction * old * 0.5;
    // Along an axis that the handle does not drag, the rectangle grows around its centre.
    const auto side = [&](int axis, int end) {
        const bool free = anchor == Anchor::Centre || direction[axis] == 0;
        if (free)
            return centre[axis] + end * size[axis] * 0.5;
        return end * direction[axis] > 0 ? fixed[axis] + direction[axis] * size[axis] : fixed[axis];
    };
    clipping::Window result = ordered({side(0, -1), side(1, -1)}, {side(0, 1), side(1, 1)});
    for (int axis = 0; axis < 2; ++axis) // sides that are not dragged stay bit for bit
        if (proportion == Proportion::Free && direction[axis] == 0) {
            result.min[axis] = start.min[axis];
            result.max[axis] = start.max[axis];
        }
    return result;
}

clipping::Window between(const Point& from, const Point& to, Proportion proportion, Anchor anchor)
{
    Point size = to - from;
    if (proportion != Proportion::Free) {
        const double longer = std::max(std::abs(size.x), std::abs(size.y));
        size = {std::copysign(longer, size.x), std::copysign(longer, size.y)};
    }
    return anchor == Anchor::Centre         ? ordered(from - size, from + size)
           : proportion == Proportion::Free ? ordered(from, to)
                                            : ordered(from, from + size);
}

} // namespace app
