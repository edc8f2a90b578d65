// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/window_points.h"

#include "app/document/window_outline.h"

namespace app {
namespace {

OwnPoints ofRectangle(const RectangleShape& rectangle)
{
    OwnPoints own = ownPointsOf(rectangle.box);
    for (Point& point : own.points)
        point = outOfFrame(rectangle, point);
    own.bounds = boxOf(rectangle);
    return own;
}

OwnPoints ofEllipse(const EllipseRecipe& ellipse, const clipping::Window& bounds)
{
    const Point x(ellipse.radii.x, 0), y(0, ellipse.radii.y);
    const Point& centre = ellipse.centre;
    return {{centre, centre - x, centre + x, centre - y, centre + y}, bounds};
}

OwnPoints ofCorners(const PathShape& shape, const clipping::Window& bounds)
{
    OwnPoints own{{}, bounds};
    for (const auto& ring : outlineOf(shape, 1).rings)
        for (const Point& corner : ring)
            if (own.points.size() < OwnPoints::most)
                own.points.push_back(corner);
    return own;
}

} // namespace

OwnPoints ownPointsOf(const WindowShape& shape)
{
    if (const auto* rectangle = std::get_if<RectangleShape>(&shape))
        return ofRectangle(*rectangle);
    const auto& path = std::get<PathShape>(shape);
    const clipping::Window bounds = boxOf(shape);
    if (const auto* ellipse = std::get_if<EllipseRecipe>(&path.recipe))
        return ofEllipse(*ellipse, bounds);
    return path.path.straight() ? ofCorners(path, bounds) : ownPointsOf(bounds);
}

} // namespace app
