// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <concepts>

namespace clipping {

/// The sides of the window that a point is strictly beyond: a sum of these bits, 0 inside.
namespace outcode {
inline constexpr unsigned left = 1, right = 2, bottom = 4, top = 8; // 16 and 32 on the third axis
} // namespace outcode

/// The side of an axis that a number is strictly beyond: `left` below `low`, `right` above `high`.
/// At most two comparisons.
template <class T>
constexpr unsigned sideBeyond(const T& v, const T& low, const T& high)
{
    return v < low ? outcode::left : v > high ? outcode::right : 0;
}

/// The same for plain numbers, without branches, because they could not be predicted.
template <std::floating_point T>
constexpr unsigned sideBeyond(const T& v, const T& low, const T& high)
{
    const unsigned below = v < low ? 1 : 0;
    const unsigned above = v > high ? 1 : 0;
    return below | (above & ~below) << 1;
}

template <class T, glm::length_t N>
constexpr unsigned outcodeOf(const glm::vec<N, T>& p, const BasicWindow<T, N>& w)
{
    unsigned code = 0;
    for (glm::length_t k = 0; k < N; ++k)
        code |= sideBeyond(p[k], w.min[k], w.max[k]) << 2 * k;
    return code;
}

} // namespace clipping
