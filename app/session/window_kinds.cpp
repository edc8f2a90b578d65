// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_kinds.h"

#include "app/document/recipe_outline.h"
#include "app/document/window_frame.h"
#include "app/drawing/centred_shapes.h"

#include <QtGlobal>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace app {
namespace {

clipping::Window boxOf(const WindowDrag& drag)
{
    return between(drag.from, drag.to, drag.proportion, drag.anchor);
}

WindowShape made(const Recipe& recipe)
{
    const auto outline = outlineOf(recipe);
    return PathShape{Path({&*outline, 1}), FillRule::NonZero, recipe};
}

WindowShape rectangle(const clipping::Window& box) { return RectangleShape{box}; }
WindowShape rectangleDrawn(const WindowDrag& drag) { return rectangle(boxOf(drag)); }

WindowShape ellipse(const clipping::Window& box)
{
    return made(EllipseRecipe{centreOf(box), (box.max - box.min) * 0.5});
}
WindowShape ellipseDrawn(const WindowDrag& drag) { return ellipse(boxOf(drag)); }

StarRecipe starIn(const clipping::Window& box, int points, double inner)
{
    const Point half = (box.max - box.min) * 0.5;
    const double radius = std::min(half.x, half.y);
    return {centreOf(box), radius, radius * inner, -std::numbers::pi / 2, points};
}

WindowShape hexagon(const clipping::Window& box) { return made(starIn(box, 6, 0)); }
WindowShape polygonDrawn(const WindowDrag& drag)
{
    return made(polygonTo(drag.from, drag.to, drag.numbers, drag.anchor));
}
const GestureMeasure& ofPolygon(Proportion, Anchor) { return polygonMeasure(); }

WindowShape star(const clipping::Window& box) { return made(starIn(box, 5, 0.45)); }
WindowShape starDrawn(const WindowDrag& drag)
{
    return made(starTo(drag.from, drag.to, drag.numbers));
}
const GestureMeasure& ofStar(Proportion, Anchor) { return starMeasure(); }

// With Alt a window is drawn from its centre, and may begin inside another one.
constexpr std::array kinds{
    WindowKind{
        "rectangle", QT_TRANSLATE_NOOP("Text", "Rectangle"),
        QT_TRANSLATE_NOOP("Text", "Drag to draw a window. Shift: square, Alt: from the centre."),
        QT_TRANSLATE_NOOP(
            "Text", "Drag beside the windows to draw one, with Alt inside one. Shift: square. "
                    "Drag one: move."),
        rectangle, rectangleDrawn, widthAndHeight},
    WindowKind{
        "ellipse", QT_TRANSLATE_NOOP("Text", "Ellipse"),
        QT_TRANSLATE_NOOP("Text", "Drag to draw a window. Shift: circle, Alt: from the centre."),
        QT_TRANSLATE_NOOP(
            "Text", "Drag beside the windows to draw one, with Alt inside one. Shift: circle. "
                    "Drag one: move."),
        ellipse, ellipseDrawn, widthAndHeight},
    WindowKind{
        "polygon", QT_TRANSLATE_NOOP("Text", "Regular polygon"),
        QT_TRANSLATE_NOOP("Text", "Drag from the centre to a corner. Up, Down: number of corners. "
                                  "Alt: to a side."),
        QT_TRANSLATE_NOOP("Text", "Drag from the centre to a corner. Up, Down: corners. Alt: to a "
                                  "side, inside a window."),
        hexagon, polygonDrawn, ofPolygon, usualPolygon},
    WindowKind{
        "star", QT_TRANSLATE_NOOP("Text", "Star"),
        QT_TRANSLATE_NOOP("Text", "Drag from the centre to a point. Up, Down: number of points. "
                                  "Shift: 15° steps."),
        QT_TRANSLATE_NOOP("Text", "Drag from the centre to a point. Up, Down: points. Shift: 15° "
                                  "steps, Alt: inside a window."),
        star, starDrawn, ofStar, usualStar},
    WindowKind{"polyline", QT_TRANSLATE_NOOP("Text", "Polygon, corner by corner"),
               QT_TRANSLATE_NOOP("Text",
                                 "Click corner by corner. Click the first corner, or press Enter, "
                                 "to close it."),
               QT_TRANSLATE_NOOP("Text",
                                 "Click corner by corner, the first one again to close. Alt: begin "
                                 "inside a window.")},
};

} // namespace

std::span<const WindowKind> windowKinds() { return kinds; }

const WindowKind& windowKind(std::string_view key)
{
    const auto found = std::ranges::find(kinds, key, &WindowKind::key);
    return found == kinds.end() ? kinds.front() : *found;
}

} // namespace app
