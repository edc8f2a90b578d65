// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/window_points.h"

#include "app/base/text.h"
#include "app/document/window_outline.h"
#include "app/view/snapping/kinds.h"
#include "app/view/snapping/places.h"

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
    const Point x = turnedBy({ellipse.radii.x, 0}, ellipse.turn),
                y = turnedBy({0, ellipse.radii.y}, ellipse.turn);
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

SnapKind windowEdges()
{
    static constexpr clipping::Segment window[]{{{-1, -1}, {1, -1}},
                                                {{1, -1}, {1, 1}},
                                                {{1, 1}, {-1, 1}},
                                                {{-1, 1}, {-1, -1}},
                                                {{-1, 0.2}, {1, -0.4}}};
    return {.key = "window",
            .name = Text::tr("Window edges and corners"),
            .word = Text::tr("window edge"),
            .cornerWord = Text::tr("window corner"),
            .rank = SnapRank::Along,
            .glyph = window,
            .find = [](const SnapSurroundings& near, SnapOffers& offers) {
                for (const auto& edge : near.windowEdges) {
                    if (edge.a != edge.b) // otherwise an outermost point of an ellipse
                        offers.addCorner(edge.a);
                    offers.add(nearestOn(edge, near.pointer));
                }
            }};
}

} // namespace app
