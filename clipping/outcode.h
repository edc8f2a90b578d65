// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <concepts>

namespace CLEARCUT_API clipping {

/// The bits of an outcode: the sides of the window that a point is strictly beyond. The next two
/// bits, 16 and 32, are those of the third axis.
namespace outcode {
inline constexpr unsigned left = 1;   ///< x < xmin
inline constexpr unsigned right = 2;  ///< x > xmax
inline constexpr unsigned bottom = 4; ///< y < ymin
inline constexpr unsigned top = 8;    ///< y > ymax
} // namespace outcode

/// The side of an axis that a number is strictly beyond: `left` below `low`, `right` above `high`.
/// 0 between them, and for a NaN. At most two comparisons.
template <class T>
constexpr unsigned sideBeyond(const T& v, const T& low, const T& high) noexcept
{
    return v < low ? outcode::left : v > high ? outcode::right : 0;
}

/// The same for plain numbers, without branches, because they could not be predicted.
template <std::floating_point T>
constexpr unsigned sideBeyond(const T& v, const T& low, const T& high) noexcept
{
    const unsigned below = v < low ? 1 : 0;
    const unsigned above = v > high ? 1 : 0;
    return below | (above & ~below) << 1;
}

/// The outcode of a point: the sum of its bits, 0 in the window and on its edges. The window has
/// min <= max on every axis.
template <class T, glm::length_t N>
constexpr unsigned outcodeOf(const glm::vec<N, T>& p, const BasicWindow<T, N>& w) noexcept
{
    unsigned code = 0;
    for (glm::length_t k = 0; k < N; ++k)
        code |= sideBeyond(p[k], w.min[k], w.max[k]) << 2 * k;
    return code;
}

} // namespace clipping
