// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Random clip windows of all shapes, and what they keep of a line, in fractions.

#include "app/document/recipe_outline.h"
#include "app/scene/region.h"

#include <cmath>
#include <random>

#include "tests/clipping/region/oracle.h"

inline app::PathShape shapeOf(const app::Recipe& recipe,
                              app::FillRule rule = app::FillRule::NonZero)
{
    const auto outline = outlineOf(recipe);
    return {app::Path({&*outline, 1}), rule, recipe};
}

/// The shapes, from those that every algorithm can clip at to those that few can.
enum class Mixed { Rectangle, Rotated, Convex, Any };

class MixedWindows {
public:
    explicit MixedWindows(unsigned seed) : random_(seed) {}

    double number(double from, double to)
    {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
    app::Point point() { return {number(-10, 110), number(-10, 110)}; }
    clipping::Segment line() { return {point(), point()}; }

    app::WindowShape shape(Mixed kind)
    {
        const app::Point centre(number(20, 80), number(20, 80)), half(number(8, 40), number(8, 40));
        switch (kind) {
        case Mixed::Rectangle:
            return app::RectangleShape{{centre - half, centre + half}};
        case Mixed::Rotated:
            return app::RectangleShape{{centre - half, centre + half}, number(-3, 3)};
        case Mixed::Convex:
            if (whole(0, 1))
                return shapeOf(app::EllipseRecipe{centre, half, number(0, 3)});
            return shapeOf(app::StarRecipe{centre, half.x, 0, number(0, 6), whole(3, 9)});
        case Mixed::Any:
            break;
        }
        return shapeOf(app::StarRecipe{centre, half.x, 0.4 * half.x, number(0, 6), whole(3, 7)},
                       app::FillRule(whole(0, 1)));
    }
    app::ClipWindows windows(int count, Mixed most)
    {
        app::ClipWindows all{{}, app::Keep(whole(0, 1))};
        for (int i = 0; i < count; ++i)
            all.list.push_back({.shape = shape(Mixed(whole(0, int(most)))),
                                .operation = app::WindowOperation(i == 0 ? 0 : whole(0, 2))});
        return all;
    }

private:
    std::mt19937 random_;
};

/// The windows of a region as areas, made here: not by the program's own function.
inline clipping::Region areasOf(const app::ClipRegion& region)
{
    clipping::Region all{{}, clipping::Keep(region.keep)};
    for (const auto& step : region.steps) {
        clipping::Area area{{}, {}, clipping::FillRule(step.rule)};
        const auto& [min, max] = step.box;
        if (step.rings.empty() && min.x < max.x && min.y < max.y)
            area.points = {min, {max.x, min.y}, max, {min.x, max.y}};
        for (const auto& ring : step.rings) {
            area.points.insert(area.points.end(), ring.begin(), ring.end());
            area.ringEnds.push_back(std::uint32_t(area.points.size()));
        }
        all.steps.push_back({area, clipping::AreaOperation(step.operation)});
    }
    return all;
}
