// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <concepts>

namespace clipping {

/// The sides of the window that a point lies strictly beyond: a sum of these bits, 0 inside.
namespace outcode {
inline constexpr unsigned left = 1, right = 2, bottom = 4, top = 8; // 16 and 32 on the third axis
} // namespace outcode

/// At most two comparisons an axis: a point beyond one side is not asked about the other.
template <class T, glm::length_t N>
constexpr unsigned outcodeOf(const glm::vec<N, T>& p, const BasicWindow<T, N>& w)
{
    unsigned code = 0;
    for (glm::length_t k = 0; k < N; ++k)
        code |= p[k] < w.min[k]   ? outcode::left << 2 * k
                : p[k] > w.max[k] ? outcode::right << 2 * k
                                  : 0;
    return code;
}

/// The same for plain numbers in the plane, without a branch, which nothing would foretell.
template <std::floating_point T>
constexpr unsigned outcodeOf(const glm::vec<2, T>& p, const BasicWindow<T, 2>& w)
{
    const auto axis = [](T v, T low, T high) {
        const unsigned below = v < low ? 1 : 0;
        const unsigned above = v > high ? 1 : 0;
        return below | (above & ~below) << 1;
    };
    return axis(p.x, w.min.x, w.max.x) | axis(p.y, w.min.y, w.max.y) << 2;
}

} // namespace clipping
