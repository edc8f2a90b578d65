// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <random>

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

} // namespace app
