// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

namespace clipping {

/// The number of [low, high] that is nearest to v. Two comparisons at most.
template <class T>
constexpr T clamped(T v, T low, T high)
{
    return v < low ? low : v > high ? high : v;
}

/// The point of the window that is nearest to p: p itself, bit for bit, if it is inside.
template <class T>
constexpr glm::vec<2, T> clamped(const glm::vec<2, T>& p, const BasicWindow<T>& w)
{
    return {clamped(p.x, w.min.x, w.max.x), clamped(p.y, w.min.y, w.max.y)};
}

/// The same for a p that has the coordinate of `edge`, which needs no comparison; with Edge::None
/// p itself.
template <class T>
constexpr glm::vec<2, T> clampedAlong(Edge edge, const glm::vec<2, T>& p, const BasicWindow<T>& w)
{
    if (edge == Edge::Left || edge == Edge::Right)
        return {p.x, clamped(p.y, w.min.y, w.max.y)};
    if (edge == Edge::Bottom || edge == Edge::Top)
        return {clamped(p.x, w.min.x, w.max.x), p.y};
    return p;
}

} // namespace clipping
