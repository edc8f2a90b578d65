// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/spread_points.h"

#include "app/document/flatten.h"
#include "app/document/path.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app::svg {
namespace {

constexpr double least = 1e-300; // of a size that can be divided

struct Crossing {
    double x = 0;
    int direction = 0;
};

struct FlatPaths {
    std::vector<Chord> chords{};
    Point min{}, max{};
};

FlatPaths flattened(std::span<const Subpath> paths)
{
    FlatPaths flat;
    bool any = false;
    for (const Subpath& path : paths)
        forEachPoint(path, [&](const Point& p) {
            flat.min = any ? glm::min(flat.min, p) : p;
            flat.max = any ? glm::max(flat.max, p) : p;
            any = true;
        });
    const Point size = flat.max - flat.min;
    const double tolerance = std::max({size.x, size.y, least}) / 100;
    for (const Subpath& path : paths)
        flatten(path, tolerance, flat.chords);
    return flat;
}

// Where the row crosses the lines, and those that close open paths, as a fill does.
std::vector<std::vector<Crossing>> crossingsOf(std::span<const Subpath> paths,
                                               const FlatPaths& flat, int rows)
{
    std::vector<std::vector<Crossing>> all(static_cast<std::size_t>(rows));
    const double step = (flat.max.y - flat.min.y) / rows;
    const auto add = [&](const Point& a, const Point& b) {
        const auto rowAfter = [&](double y) {
            return std::clamp(int(std::ceil((y - flat.min.y) / step - 0.5)), 0, rows);
        };
        for (int row = rowAfter(std::min(a.y, b.y)); row < rowAfter(std::max(a.y, b.y)); ++row) {
            const double y = flat.min.y + (row + 0.5) * step;
            all[std::size_t(row)].push_back(
                {a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)), a.y < b.y ? 1 : -1});
        }
    };
    for (const Chord& chord : flat.chords)
        add(chord.segment.a, chord.segment.b);
    for (const Subpath& path : paths)
        if (!path.closed && !path.segments.empty())
            add(path.segments.back().to, path.start);
    return all;
}

void addSpan(double from, double to, double y, double step, std::vector<SpreadPoint>& points)
{
    const double count = std::max(std::ceil((to - from) / step), 1.0);
    const double width = (to - from) / count;
    for (double i = 0; width > 0 && i < count; ++i)
        points.push_back({{from + (i + 0.5) * width, y}, width});
}

} // namespace

std::vector<SpreadPoint> pointsInside(std::span<const Subpath> paths, FillRule rule, int rows)
{
    std::vector<SpreadPoint> points;
    const FlatPaths flat = flattened(paths);
    const Point size = flat.max - flat.min;
    if (!(size.x > least && size.y > least))
        return points;
    auto all = crossingsOf(paths, flat, rows);
    for (std::size_t row = 0; row < all.size(); ++row) {
        std::ranges::sort(all[row], {}, &Crossing::x);
        const double y = flat.min.y + (double(row) + 0.5) * size.y / rows;
        int winding = 0;
        for (std::size_t i = 0; i + 1 < all[row].size(); ++i) {
            winding += all[row][i].direction;
            if (rule == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0)
                addSpan(all[row][i].x, all[row][i + 1].x, y, size.x / rows, points);
        }
    }
    return points;
}

std::vector<SpreadPoint> pointsAlong(std::span<const Subpath> paths, int rows)
{
    std::vector<SpreadPoint> points;
    const FlatPaths flat = flattened(paths);
    const Point size = flat.max - flat.min;
    const double step = std::max(size.x, size.y) / rows;
    for (const Chord& chord : flat.chords) {
        const auto& [a, b] = chord.segment;
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        const double count = std::clamp(std::ceil(length / step), 1.0, double(2 * rows));
        for (double i = 0; length > 0 && i < count; ++i)
            points.push_back({a + (b - a) * ((i + 0.5) / count), length / count});
    }
    return points;
}

} // namespace app::svg
