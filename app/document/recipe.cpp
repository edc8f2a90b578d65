// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe.h"

#include "app/document/path.h"
#include "app/document/recipe_outline.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace app {
namespace {

bool alike(const Point& scale) { return std::abs(scale.x) == std::abs(scale.y); }

/// Two sides of a shape at right angles, and the direction of the first.
struct Sides {
    Point lengths;
    double turn = 0;
};

/// The images of two sides; empty if they are no longer at right angles. A turn that rounding only
/// keeps from a multiple of a right angle is one.
std::optional<Sides> sidesAfter(const AffineMap& map, const Sides& before)
{
    const auto image = [&](const Point& side) {
        const Point own = turnedBy(side, before.turn);
        return map.x * own.x + map.y * own.y;
    };
    constexpr double rounding = 1e-12; // relative to the lengths, or in radians
    const Point x = image({before.lengths.x, 0}), y = image({0, before.lengths.y});
    const Point lengths(glm::length(x), glm::length(y));
    if (!(std::abs(glm::dot(x, y)) <= rounding * lengths.x * lengths.y))
        return std::nullopt;
    // A mirrored shape has the same points as a turned one.
    const double turn = lengths.x > 0 ? std::atan2(x.y, x.x) : std::atan2(-y.x, y.y);
    constexpr double right = std::numbers::pi / 2;
    const double rights = std::round(turn / right);
    if (std::abs(turn - rights * right) > rounding)
        return Sides{lengths, turn};
    return Sides{std::fmod(rights, 2) == 0 ? lengths : Point(lengths.y, lengths.x)};
}

AffineMap mapOf(const Placement& where)
{
    return {{where.scale.x, 0}, {0, where.scale.y}, Point(0), where(Point(0))};
}

Recipe turnedRectangle(const RectangleRecipe& r, const AffineMap& map)
{
    const auto sides = sidesAfter(map, {r.size, r.turn});
    if (!sides)
        return {};
    const Point centre = map(r.corner + r.size * 0.5), size = sides->lengths;
    if (r.radius == 0)
        return RectangleRecipe{centre - size * 0.5, size, 0, sides->turn};
    const auto circles = sidesAfter(map, {Point(r.radius), r.turn});
    const double radius = circles ? circles->lengths.x : 0;
    if (!circles || std::abs(circles->lengths.y - radius) > roundingOfRecipes * radius)
        return {}; // the rounded corners become elliptical
    return RectangleRecipe{centre - size * 0.5, size, radius, sides->turn};
}

Recipe turnedEllipse(const EllipseRecipe& e, const AffineMap& map)
{
    const auto sides = sidesAfter(map, {e.radii, e.turn});
    if (!sides)
        return {};
    const double radius = (sides->lengths.x + sides->lengths.y) / 2;
    const bool isCircle = std::abs(sides->lengths.x - radius) <= roundingOfRecipes * radius;
    return EllipseRecipe{map(e.centre), isCircle ? Point(radius) : sides->lengths,
                         isCircle ? 0 : sides->turn};
}

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
        if (where.scale == Point(1)) // with every bit of the size and the turn
            return RectangleRecipe{where(r.corner), r.size, r.radius, r.turn};
        if (r.turn != 0 || (r.radius != 0 && !alike(where.scale)))
            return turnedRectangle(r, mapOf(where));
        const Point a = where(r.corner), b = where(r.corner + r.size);
        return RectangleRecipe{glm::min(a, b), glm::abs(b - a), r.radius * std::abs(where.scale.x)};
    }
    Recipe operator()(const EllipseRecipe& r) const
    {
        if (r.turn != 0 && where.scale != Point(1))
            return turnedEllipse(r, mapOf(where));
        return EllipseRecipe{where(r.centre), r.radii * glm::abs(where.scale), r.turn};
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
        if (!swapsAxes || r.turn != 0 || (r.radius != 0 && !keepsShape))
            return turnedRectangle(r, map);
        const Point a = map(r.corner), b = map(r.corner + r.size); // as exact as the corners
        return RectangleRecipe{glm::min(a, b), glm::abs(b - a), r.radius * map.scale()};
    }
    Recipe operator()(const EllipseRecipe& e) const { return turnedEllipse(e, map); }
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

Point turnedBy(const Point& vector, double turn)
{
    if (turn == 0)
        return vector; // with every bit
    const double sine = std::sin(turn), cosine = std::cos(turn);
    return {vector.x * cosine - vector.y * sine, vector.x * sine + vector.y * cosine};
}

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
