// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/copy_place.h"

#include "app/document/path_points.h"

#include <algorithm>
#include <functional>
#include <unordered_map>

namespace app {
namespace {

constexpr int mostSteps = 1000;

std::size_t keyOf(const Point& start)
{
    return std::hash<double>{}(start.x) * 31 + std::hash<double>{}(start.y);
}

Shape moved(Shape shape, const Point& by)
{
    for (Subpath& path : shape.paths)
        forEachPoint(path, [&](Point& point) { point += by; });
    return shape;
}

/// The shapes of a drawing by where they start.
class Starts {
public:
    explicit Starts(const Sheet& sheet)
    {
        shapes_.reserve(sheet.shapes.size());
        for (const Shape& shape : sheet.shapes)
            if (!shape.paths.empty())
                shapes_.emplace(keyOf(shape.paths.front().start), &shape);
    }
    bool hold(const Shape& shape, const Point& offset) const
    {
        if (shape.paths.empty())
            return false;
        const auto [first, last] = shapes_.equal_range(keyOf(shape.paths.front().start + offset));
        return std::any_of(first, last, [&](const auto& entry) {
            return entry.second->paths == moved(shape, offset).paths;
        });
    }

private:
    std::unordered_multimap<std::size_t, const Shape*> shapes_;
};

} // namespace

Point copyOffset(const Sheet& sheet, const std::vector<Shape>& shapes, const Point& step)
{
    const Starts starts(sheet);
    for (int steps = 1; steps < mostSteps; ++steps) {
        const Point offset = double(steps) * step;
        if (std::ranges::none_of(shapes, [&](const Shape& s) { return starts.hold(s, offset); }))
            return offset;
    }
    return double(mostSteps) * step;
}

} // namespace app
