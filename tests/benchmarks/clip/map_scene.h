// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/benchmarks/clip/map.h"
#include "tests/benchmarks/scenes.h"

/// The real map side by side on a square of sheets, as many as are needed; the window shows the
/// middle ninth of all. Without the map: no segments.
template <class T>
Scene<T> mapSheets(std::size_t count)
{
    Scene<T> result{"map", paperWindow<T>(), {}};
    const Map& map = realMap();
    if (map.segments.empty())
        return result;
    const auto side =
        static_cast<std::size_t>(std::ceil(std::sqrt(double(count) / double(map.segments.size()))));
    const glm::dvec2 size = map.around.max - map.around.min, sheets = size * double(side);
    const double scale = 600 / sheets.x;
    for (std::size_t i = 0; i < side * side; ++i) {
        const glm::dvec2 corner(double(i % side) * size.x, double(i / side) * size.y);
        const auto placed = [&](const glm::dvec2& p) {
            return glm::vec<2, T>((p - map.around.min + corner - sheets / 2.0) * scale);
        };
        for (const auto& [a, b] : map.segments)
            if (result.segments.size() < count)
                result.segments.push_back({placed(a), placed(b)});
    }
    return result;
}

/// Those that everybody can make, and the map.
template <class T>
std::vector<SceneMaker<T>> scenesWithMap()
{
    auto all = benchmarkScenes<T>;
    all.push_back({"map", mapSheets<T>});
    return all;
}
