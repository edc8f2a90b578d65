// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/clipping/scenes.h"

/// A scene by name; made anew for each number of segments, since ten million take 320 MB.
template <class T>
struct SceneMaker {
    const char* name;
    Scene<T> (*make)(std::size_t count);
};

template <class T>
clipping::BasicWindow<T> paperWindow()
{
    return {{-100, -75}, {100, 75}};
}

template <class T>
glm::vec<2, T> anywhere(RandomNumbers& random, double width, double height)
{
    const auto x = static_cast<T>(random.uniform(-width, width));
    return {x, static_cast<T>(random.uniform(-height, height))};
}

template <class T, class Make>
Scene<T> sceneOf(const char* name, std::size_t count, Make make)
{
    Scene<T> result{name, paperWindow<T>(), {}};
    result.segments.reserve(count);
    RandomNumbers random(count);
    while (result.segments.size() < count)
        make(random, result.segments);
    return result;
}

template <class T>
Scene<T> allInside(std::size_t count)
{
    return sceneOf<T>("all inside", count, [](RandomNumbers& random, auto& to) {
        const auto a = anywhere<T>(random, 100, 75);
        to.push_back({a, anywhere<T>(random, 100, 75)});
    });
}

template <class T>
Scene<T> oneEndInside(std::size_t count)
{
    return sceneOf<T>("one end inside", count, [](RandomNumbers& random, auto& to) {
        const auto a = anywhere<T>(random, 100, 75);
        auto b = anywhere<T>(random, 960, 720);
        while (std::abs(b.x) <= 100 && std::abs(b.y) <= 75)
            b = anywhere<T>(random, 960, 720);
        random.bits() & 1 ? to.push_back({a, b}) : to.push_back({b, a});
    });
}

/// Short lines, none of which reaches the window.
template <class T>
Scene<T> allOutside(std::size_t count)
{
    return sceneOf<T>("all outside", count, [](RandomNumbers& random, auto& to) {
        const auto a = anywhere<T>(random, 960, 720);
        if (std::abs(a.x) > 120 || std::abs(a.y) > 95)
            to.push_back({a, a + anywhere<T>(random, 20, 20)});
    });
}

/// Through the neighbourhood of the window, a million long: hardest on the last bits.
template <class T>
Scene<T> longLines(std::size_t count)
{
    return sceneOf<T>("long lines", count, [](RandomNumbers& random, auto& to) {
        const auto middle = anywhere<T>(random, 200, 150);
        const double angle = random.uniform(0, 2 * std::numbers::pi), at = random.uniform(0, 1);
        const glm::dvec2 whole{1e6 * std::cos(angle), 1e6 * std::sin(angle)};
        to.push_back(
            {middle - glm::vec<2, T>(whole * at), middle + glm::vec<2, T>(whole * (1 - at))});
    });
}

/// Pen strokes of 200 short segments on a sheet of a hundred windows: 1 % is visible.
template <class T>
Scene<T> strokes(std::size_t count)
{
    return sceneOf<T>("editor strokes", count, [count](RandomNumbers& random, auto& to) {
        auto at = anywhere<double>(random, 1000, 750);
        double direction = random.uniform(0, 2 * std::numbers::pi), turn = 0;
        for (int i = 0; i < 200 && to.size() < count; ++i) {
            turn = 0.9 * turn + random.uniform(-0.05, 0.05);
            direction += turn;
            glm::dvec2 next = at + 2.0 * glm::dvec2{std::cos(direction), std::sin(direction)};
            next = {std::clamp(next.x, -1000.0, 1000.0), std::clamp(next.y, -750.0, 750.0)};
            to.push_back({glm::vec<2, T>(at), glm::vec<2, T>(next)});
            at = next;
        }
    });
}

template <class T>
const std::vector<SceneMaker<T>> benchmarkScenes{
    {"paper", paperScene<T>},
    {"all inside", allInside<T>},
    {"one end inside", oneEndInside<T>},
    {"all outside", allOutside<T>},
    {"long lines", longLines<T>},
    {"editor strokes", strokes<T>},
};
