// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

/// Segments and the window to clip them with, in the numbers of T.
template <class T>
struct Scene {
    std::string name;
    clipping::BasicWindow<T> window;
    std::vector<clipping::BasicSegment<T>> segments;
};

/// Random numbers, the same on every machine.
class RandomNumbers {
public:
    explicit RandomNumbers(std::uint64_t seed) : engine_(seed) {}
    std::uint64_t bits() { return engine_(); }
    int integer(int low, int high)
    {
        return low + static_cast<int>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }
    double uniform(double low, double high)
    {
        return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
    }
    /// Any finite number, each exponent as likely as another.
    template <class T>
    T anyFinite()
    {
        for (;;) {
            T x;
            if constexpr (sizeof(T) == 8)
                x = std::bit_cast<T>(bits());
            else
                x = std::bit_cast<T>(static_cast<std::uint32_t>(bits()));
            if (std::isfinite(x))
                return x;
        }
    }

private:
    std::mt19937_64 engine_;
};

/// A scene of `count` segments, each end from `end(random)`.
template <class T, class End>
Scene<T> scene(std::string name, clipping::BasicWindow<T> window, std::size_t count, End end)
{
    Scene<T> result{std::move(name), window, {}};
    RandomNumbers random(count + result.name.size());
    for (std::size_t i = 0; i < count; ++i)
        result.segments.push_back({end(random), end(random)});
    return result;
}

/// The paper's: ends anywhere in 1920 x 1440 around a window of 200 x 150.
template <class T>
Scene<T> paperScene(std::size_t count)
{
    return scene<T>("paper", {{-100, -75}, {100, 75}}, count, [](RandomNumbers& random) {
        const auto x = static_cast<T>(random.uniform(-960, 960));
        return glm::vec<2, T>{x, static_cast<T>(random.uniform(-720, 720))};
    });
}

/// Scenes that are hard to get right: contacts, corners, edges, long and tiny and huge numbers.
template <class T>
std::vector<Scene<T>> hardScenes(std::size_t count)
{
    using V = glm::vec<2, T>;
    const auto grid = [](int low, int high, T unit) {
        return [=](RandomNumbers& random) {
            const int x = random.integer(low, high);
            return V{T(x) * unit, T(random.integer(low, high)) * unit};
        };
    };
    const auto longLines = [](RandomNumbers& random) {
        const double length = std::exp2(random.uniform(0, 40));
        const double x = random.uniform(-length, length);
        return V{static_cast<T>(x), static_cast<T>(random.uniform(-length, length))};
    };
    const auto hugging =
        [](RandomNumbers& random) { // within a few of the smallest steps of the edge
            const auto x = static_cast<T>(random.integer(-3000, 3000) / 16.0);
            const T edge = random.integer(0, 1) == 0 ? T(-75) : T(75);
            return V{x, edge + T(random.integer(-8, 8)) * std::numeric_limits<T>::epsilon() * 64};
        };
    const auto anything = [](RandomNumbers& random) {
        const T x = random.anyFinite<T>();
        return V{x, random.anyFinite<T>()};
    };
    const auto mixed = [](RandomNumbers& random) { // ordinary beside extreme
        const auto one = [&random] {
            return random.integer(0, 3) == 0 ? random.anyFinite<T>() : T(random.integer(-4, 4));
        };
        const T x = one();
        return V{x, one()};
    };
    const T least = std::numeric_limits<T>::denorm_min(), most = std::numeric_limits<T>::max();
    return {
        paperScene<T>(count),
        scene<T>("small whole numbers", {{-2, -1}, {2, 3}}, count, grid(-6, 6, T(1))),
        scene<T>("tenths", {{T(0.1), T(0.1)}, {T(0.7), T(0.9)}}, count, grid(-15, 25, T(0.1))),
        scene<T>("a window without width", {{1, -2}, {1, 2}}, count, grid(-4, 4, T(1))),
        scene<T>("a window of one point", {{1, 1}, {1, 1}}, count, grid(-4, 4, T(1))),
        scene<T>("long lines", {{-100, -75}, {100, 75}}, count, longLines),
        scene<T>("along the edges", {{-100, -75}, {100, 75}}, count, hugging),
        scene<T>("any finite number", {{-most / 2, -1}, {1, most / 4}}, count, anything),
        scene<T>("ordinary and extreme", {{-1, -2}, {3, 1}}, count, mixed),
        scene<T>("the smallest numbers", {{-2 * least, -least}, {2 * least, 3 * least}}, count,
                 grid(-6, 6, least)),
        scene<T>("the largest numbers", {{-most, -most / 3}, {most / 2, most}}, count,
                 grid(-4, 4, most / 4)),
    };
}
