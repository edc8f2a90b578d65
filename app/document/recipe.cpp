// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"

#include <glm/common.hpp>

#include <cmath>
#include <numbers>

namespace app {
namespace {

bool alike(const Point& scale) { return std::abs(scale.x) == std::abs(scale.y); }

struct Placed {
    const Placement& where;

    Recipe operator()(std::monostate nothing) const { return nothing; }
    Recipe operator()(const RectangleRecipe& r) const
    {
        if (r.radius != 0 && !alike(where.scale)) // the rounded corners become elliptical
            return {};
        const Point a = where(r.corner), b = where(r.corner + r.size);
        return RectangleRecipe{glm::min(a, b), glm::abs(b - a), r.radius * std::abs(where.scale.x)};
    }
    Recipe operator()(const EllipseRecipe& r) const
    {
        return EllipseRecipe{where(r.centre), r.radii * glm::abs(where.scale)};
    }
    Recipe operator()(const StarRecipe& r) const
    {
        if (!alike(where.scale))
            return {};
        const double size = std::abs(where.scale.x);
        double turn = where.scale.y < 0 ? -r.turn : r.turn;
        if (where.scale.x < 0)
            turn = std::numbers::pi - turn;
        return StarRecipe{where(r.centre), r.outer * size, r.inner * size, turn, r.points};
    }
    Recipe operator()(const TextRecipe& r) const
    {
        const double size = where.scale.x;
        if (size != where.scale.y || size < 0) // a font has no stretched or mirrored letters
            return {};
        return TextRecipe{r.text, r.font, r.size * size, where(r.at)};
    }
};

} // namespace

Recipe placed(const Recipe& recipe, const Placement& where)
{
    if (where.isIdentity())
        return recipe;
    if (where.scale.x == 0 || where.scale.y == 0)
        return {};
    return std::visit(Placed{where}, recipe);
}

} // namespace app
