// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

namespace clipping {

/// The sides of the window that a point lies strictly beyond: a sum of these bits, 0 inside.
namespace outcode {
inline constexpr unsigned left = 1, right = 2, bottom = 4, top = 8;
} // namespace outcode

/// At most four comparisons: a point beyond one side of an axis is not asked about the other.
template <class T>
constexpr unsigned outcodeOf(const glm::vec<2, T>& p, const BasicWindow<T>& w)
{
    const unsigned x = p.x < w.min.x ? outcode::left : p.x > w.max.x ? outcode::right : 0;
    const unsigned y = p.y < w.min.y ? outcode::bottom : p.y > w.max.y ? outcode::top : 0;
    return x | y;
}

} // namespace clipping
