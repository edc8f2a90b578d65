// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/recipe_outline.h"

#include "app/document/arc_curves.h"
#include "app/document/direction.h"

#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <array>

namespace app {
namespace {

// Distance of control points, in radii, for a Bézier curve that approximates a quarter circle.
constexpr double quarter = 0.5522847498307936;
constexpr double rounding = 1e-9; // relative to the size

struct Outline {
    std::optional<Subpath> operator()(const RectangleRecipe& r) const
    {
        const Point end = r.corner + r.size;
        if (r.radius > 0)
            return roundedRectangle(r.corner, end, glm::min(Point(r.radius), r.size * 0.5));
        return Subpath{r.corner, {{{end.x, r.corner.y}}, {end}, {{r.corner.x, end.y}}}, true};
    }
    std::optional<Subpath> operator()(const EllipseRecipe& e) const
    {
        const auto at = [&](const Point& unit) { return e.centre + e.radii * unit; };
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

std::optional<Subpath> outlineOf(const Recipe& recipe) { return std::visit(Outline{}, recipe); }

bool makes(const Recipe& recipe, std::span<const Subpath> subpaths)
{
    const auto made = outlineOf(recipe);
    if (!made || subpaths.size() != 1 || !subpaths.front().closed
        || subpaths.front().segments.size() != made->segments.size())
        return false;
    double size = 0;
    for (const PathSegment& s : made->segments)
        size = std::max({size, std::abs(s.to.x), std::abs(s.to.y), std::abs(made->start.x),
                         std::abs(made->start.y)});
    const auto near = [&](const Point& a, const Point& b) {
        const Point apart = glm::abs(a - b);
        return apart.x <= rounding * size && apart.y <= rounding * size;
    };
    return near(made->start, subpaths.front().start)
           && std::ranges::equal(made->segments, subpaths.front().segments,
                                 [&](const PathSegment& a, const PathSegment& b) {
                                     return a.curved == b.curved && near(a.to, b.to)
                                            && near(a.control1, b.control1)
                                            && near(a.control2, b.control2);
                                 });
}

} // namespace app
