// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

namespace clipping {

/// The number in [low, high] nearest to v. At most two comparisons.
template <class T>
constexpr T clamped(T v, T low, T high)
{
    return v < low ? low : v > high ? high : v;
}

/// The point of the window nearest to p; p itself, bit for bit, if it is inside.
template <class T, glm::length_t N>
constexpr glm::vec<N, T> clamped(glm::vec<N, T> p, const BasicWindow<T, N>& w)
{
    for (glm::length_t k = 0; k < N; ++k)
        p[k] = clamped(p[k], w.min[k], w.max[k]);
    return p;
}

/// The same for a p that already has the coordinate of `edge`, which saves its comparison; p itself
/// for Edge::NoEdge.
template <class T, glm::length_t N>
constexpr glm::vec<N, T> clampedAlong(Edge edge, glm::vec<N, T> p, const BasicWindow<T, N>& w)
{
    for (glm::length_t axis = 0; axis < N; ++axis)
        // Evaluated at compile time after inlining.
        if (edge == lowerEdge(axis) || edge == upperEdge(axis))
            for (glm::length_t k = 0; k < N; ++k)
                if (k != axis)
                    p[k] = clamped(p[k], w.min[k], w.max[k]);
    return p;
}

} // namespace clipping
