// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"

#include "app/document/path.h"
#include "app/document/recipe_outline.h"

#include <glm/common.hpp>

#include <cmath>
#include <numbers>

namespace app {
namespace {

bool alike(const Point& scale) { return std::abs(scale.x) == std::abs(scale.y); }

/// A text after a map that keeps angles. It is mirrored by a map that turns x to y the other way.
TextRecipe turnedText(TextRecipe text, const AffineMap& map)
{
    const Point along = map.x * std::cos(text.turn) + map.y * std::sin(text.turn);
    text.at = map(text.at);
    text.size *= map.scale();
    text.turn = std::atan2(along.y, along.x);
    text.mirrored ^= map.x.x * map.y.y < map.x.y * map.y.x;
    return text;
}

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
        if (!alike(where.scale)) // a font has no stretched letters
            return {};
        TextRecipe text = r;
        if (where.scale.x != where.scale.y || where.scale.x < 0)
            text = turnedText(r, {{where.scale.x, 0}, {0, where.scale.y}});
        text.size = r.size * std::abs(where.scale.x);
        text.at = where(r.at);
        return text;
    }
};

/// What remains of a recipe under a map that rotates.
struct Turned {
    const AffineMap& map;
    const bool swapsAxes = map.x.x == 0 && map.y.y == 0;
    const bool keepsShape = isSimilarity();

    template <class Other>
    Recipe operator()(const Other&) const
    {
        return {};
    }
    Recipe operator()(const RectangleRecipe& r) const
    {
        if (!swapsAxes || (r.radius != 0 && !keepsShape))
            return {};
        const Point a = map(r.corner), b = map(r.corner + r.size);
        return RectangleRecipe{glm::min(a, b), glm::abs(b - a), r.radius * map.scale()};
    }
    Recipe operator()(const EllipseRecipe& r) const
    {
        if (swapsAxes)
            return EllipseRecipe{map(r.centre),
                                 {r.radii.y * std::abs(map.y.x), r.radii.x * std::abs(map.x.y)}};
        const double radius = (r.radii.x + r.radii.y) / 2;
        const bool isCircle = std::abs(r.radii.x - r.radii.y) <= roundingOfRecipes * radius;
        if (!isCircle || !keepsShape)
            return {};
        return EllipseRecipe{map(r.centre), Point(radius * map.scale())};
    }
    Recipe operator()(const StarRecipe& r) const
    {
        if (!keepsShape)
            return {};
        const Point first = map.x * std::cos(r.turn) + map.y * std::sin(r.turn);
        const double size = map.scale();
        return StarRecipe{map(r.centre), r.outer * size, r.inner * size,
                          std::atan2(first.y, first.x), r.points};
    }
    Recipe operator()(const TextRecipe& r) const
    {
        return keepsShape ? Recipe(turnedText(r, map)) : Recipe{};
    }

private:
    bool isSimilarity() const
    {
        const double most = 1e-12 * (std::abs(map.x.x) + std::abs(map.x.y));
        const auto near = [&](double a, double b) { return std::abs(a - b) <= most; };
        return (near(map.x.x, map.y.y) && near(map.x.y, -map.y.x))
               || (near(map.x.x, -map.y.y) && near(map.x.y, map.y.x));
    }
};

} // namespace

Recipe mapped(const Recipe& recipe, const AffineMap& map)
{
    if (const auto where = map.placement())
        return placed(recipe, *where);
    return map.scale() > 0 ? std::visit(Turned{map}, recipe) : Recipe{};
}

Recipe placed(const Recipe& recipe, const Placement& where)
{
    if (where.isIdentity())
        return recipe;
    if (where.scale.x == 0 || where.scale.y == 0)
        return {};
    return std::visit(Placed{where}, recipe);
}

Path mapped(const Path& path, const AffineMap& map)
{
    if (const auto line = path.singleLine())
        return Path(clipping::Segment{map(line->a), map(line->b)});
    std::vector<Subpath> subpaths = path.subpaths();
    for (Subpath& subpath : subpaths)
        forEachPoint(subpath, [&](Point& p) { p = map(p); });
    return Path(subpaths);
}

void transform(Path& path, Recipe& recipe, const AffineMap& map)
{
    recipe = mapped(recipe, map);
    const auto where = map.placement();
    const bool turns = !where || where->scale.x < 0 || where->scale.y < 0;
    const auto outline = turns ? outlineOf(recipe) : std::nullopt;
    path = outline ? Path(std::span(&*outline, 1)) : mapped(path, map);
}

} // namespace app
