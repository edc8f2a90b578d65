// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"

#include "app/document/arc_curves.h"
#include "app/document/direction.h"
#include "app/document/window_frame.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>

namespace app {
namespace {

// Distance of control points, in radii, for a Bézier curve that approximates a quarter circle.
constexpr double quarter = 0.5522847498307936;

struct OutlineOfRecipe {
    std::optional<Subpath> operator()(const RectangleRecipe& r) const
    {
        const Point end = r.corner + r.size;
        Subpath path =
            r.radius > 0
                ? roundedRectangle(r.corner, end, glm::min(Point(r.radius), r.size * 0.5))
                : Subpath{r.corner, {{{end.x, r.corner.y}}, {end}, {{r.corner.x, end.y}}}, true};
        const WindowFrame frame{{r.corner, end}, r.turn};
        forEachPoint(path, [&](Point& p) { p = outOfFrame(frame, p); });
        return path;
    }
    std::optional<Subpath> operator()(const EllipseRecipe& e) const
    {
        const auto at = [&](const Point& unit) {
            return e.centre + turnedBy(e.radii * unit, e.turn);
        };
        const auto curve = [&](const Point& a, const Point& b) { // directions a quarter turn apart
            return PathSegment{at(b), at(a + b * quarter), at(b + a * quarter), true};
        };
        return Subpath{at({1, 0}),
                       {curve({1, 0}, {0, 1}), curve({0, 1}, {-1, 0}), curve({-1, 0}, {0, -1}),
                        curve({0, -1}, {1, 0})},
                       true};
    }
    std::optional<Subpath> operator()(const StarRecipe& s) const
    {
        const double step = 180.0 / s.points, first = -glm::degrees(s.turn);
        Subpath path{s.centre + directionOf(first) * s.outer, {}, true};
        for (int i = 1; i < 2 * s.points; ++i)
            if (const double radius = i % 2 == 0 ? s.outer : s.inner; radius > 0)
                path.segments.push_back({s.centre + directionOf(first - step * i) * radius});
        return path;
    }
    template <class Other>
    std::optional<Subpath> operator()(const Other&) const
    {
        return std::nullopt;
    }
};

} // namespace

std::optional<Subpath> outlineOf(const Recipe& recipe)
{
    return std::visit(OutlineOfRecipe{}, recipe);
}

bool alike(std::span<const Subpath> a, std::span<const Subpath> b)
{
    double size = 0;
    for (const Subpath& path : a) {
        size = std::max({size, std::abs(path.start.x), std::abs(path.start.y)});
        for (const PathSegment& s : path.segments)
            size = std::max({size, std::abs(s.to.x), std::abs(s.to.y)});
    }
    const auto near = [&](const Point& p, const Point& q) {
        const Point apart = glm::abs(p - q);
        return apart.x <= roundingOfRecipes * size && apart.y <= roundingOfRecipes * size;
    };
    const auto same = [&](const PathSegment& p, const PathSegment& q) {
        return p.curved == q.curved && near(p.to, q.to) && near(p.control1, q.control1)
               && near(p.control2, q.control2);
    };
    return std::ranges::equal(a, b, [&](const Subpath& p, const Subpath& q) {
        return p.closed == q.closed && near(p.start, q.start)
               && std::ranges::equal(p.segments, q.segments, same);
    });
}

bool makes(const Recipe& recipe, std::span<const Subpath> subpaths)
{
    const auto made = outlineOf(recipe);
    return made && alike(std::span(&*made, 1), subpaths);
}

} // namespace app
