// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/window_frame.h"

#include "app/document/recipe.h"

namespace app {
namespace {

Point turnedPoint(const Point& p, const Point& centre, double angle)
{
    return angle == 0 ? p : centre + turnedBy(p - centre, angle);
}

} // namespace

Point centreOf(const clipping::Window& box) { return (box.min + box.max) * 0.5; }

std::array<Point, 4> cornersOf(const WindowFrame& frame)
{
    const auto& [min, max] = frame.box;
    std::array<Point, 4> corners{min, {max.x, min.y}, max, {min.x, max.y}};
    for (Point& corner : corners)
        corner = outOfFrame(frame, corner);
    return corners;
}

Point intoFrame(const WindowFrame& frame, const Point& p)
{
    return turnedPoint(p, centreOf(frame.box), -frame.angle);
}

Point outOfFrame(const WindowFrame& frame, const Point& p)
{
    return turnedPoint(p, centreOf(frame.box), frame.angle);
}

WindowFrame resized(const WindowFrame& frame, const clipping::Window& box)
{
    const Point half = (box.max - box.min) * 0.5;
    if (frame.angle == 0)
        return {box};
    const Point centre = outOfFrame(frame, centreOf(box));
    return {{centre - half, centre + half}, frame.angle};
}

AffineMap scalingAlong(double angle, const Point& factors, const Point& about)
{
    AffineMap map = scaling(factors, about);
    if (angle != 0)
        for (Point* const axis : {&map.x, &map.y})
            *axis = turnedBy(factors * turnedBy(axis == &map.x ? Point(1, 0) : Point(0, 1), -angle),
                             angle);
    return map;
}

AffineMap fitting(const WindowFrame& from, const WindowFrame& to)
{
    const Point old = from.box.max - from.box.min, size = to.box.max - to.box.min;
    const Point factors(old.x > 0 ? size.x / old.x : 1, old.y > 0 ? size.y / old.y : 1);
    AffineMap map = scalingAlong(from.angle, factors, centreOf(from.box));
    map.to = centreOf(to.box);
    return map;
}

} // namespace app
