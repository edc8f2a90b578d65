// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_kinds.h"

#include "app/document/recipe_outline.h"

#include <QtGlobal>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <numbers>

namespace app {
namespace {

Point centreOf(const clipping::Window& box) { return (box.min + box.max) * 0.5; }

WindowShape made(const Recipe& recipe)
{
    const auto outline = outlineOf(recipe);
    return PathShape{Path({&*outline, 1}), FillRule::NonZero, recipe};
}

WindowShape rectangle(const clipping::Window& box) { return RectangleShape{box}; }

WindowShape ellipse(const clipping::Window& box)
{
    return made(EllipseRecipe{centreOf(box), (box.max - box.min) * 0.5});
}

StarRecipe starIn(const clipping::Window& box, int points, double inner)
{
    const Point half = (box.max - box.min) * 0.5;
    const double radius = std::min(half.x, half.y);
    return {centreOf(box), radius, radius * inner, -std::numbers::pi / 2, points};
}

WindowShape hexagon(const clipping::Window& box) { return made(starIn(box, 6, 0)); }
WindowShape star(const clipping::Window& box) { return made(starIn(box, 5, 0.45)); }

constexpr std::array kinds{
    WindowKind{"rectangle", QT_TRANSLATE_NOOP("WindowKinds", "Rectangle"), rectangle},
    WindowKind{"ellipse", QT_TRANSLATE_NOOP("WindowKinds", "Ellipse"), ellipse},
    WindowKind{"polygon", QT_TRANSLATE_NOOP("WindowKinds", "Hexagon"), hexagon},
    WindowKind{"star", QT_TRANSLATE_NOOP("WindowKinds", "Star"), star},
};

} // namespace

std::span<const WindowKind> windowKinds() { return kinds; }

} // namespace app
