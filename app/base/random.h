// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <bit>
#include <cstdint>
#include <random>
#include <span>

namespace app {

/// A random number generator with the same results on every machine (std::uniform_real_distribution
/// gives no such guarantee).
class Random {
public:
    explicit Random(std::uint64_t seed) : random_(seed) {}

    /// Uniformly distributed: low <= result < high.
    double between(double low, double high)
    {
        return low + (high - low) * (double(random_() >> 11) * 0x1p-53); // 53 random bits
    }
    bool heads() { return (random_() & 1) != 0; }

    /// A point uniformly distributed in a rectangle.
    glm::dvec2 in(const clipping::Window& area)
    {
        const double x = between(area.min.x, area.max.x);
        return {x, between(area.min.y, area.max.y)};
    }

private:
    std::mt19937_64 random_;
};

/// The splitmix64 mixing function: each bit of the result depends on each bit of `x`.
constexpr std::uint64_t mixed(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}
inline std::uint64_t mixed(double x) { return mixed(std::bit_cast<std::uint64_t>(x)); }

/// A fast checksum of pixels (FNV). It depends on their order.
constexpr std::uint64_t checksumOf(std::span<const std::uint32_t> pixels)
{
    std::uint64_t sum = 0;
    for (const std::uint32_t pixel : pixels)
        sum = (sum ^ pixel) * 0x100000001b3;
    return mixed(sum);
}

} // namespace app
