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

} // namespace app
