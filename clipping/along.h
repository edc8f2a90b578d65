// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"

namespace clipping {

/// The point of a segment at t (0 at a, 1 at b), where it meets `edge`; d is b - a. The coordinate
/// on the axis perpendicular to the edge is the edge's own, the others are clamped to the window.
template <class T, glm::length_t N>
constexpr glm::vec<N, T> along(const BasicSegment<T, N>& s, const glm::vec<N, T>& d, T t, Edge edge,
                               const BasicWindow<T, N>& w)
{
    glm::vec<N, T> p = s.a;
    for (glm::length_t k = 0; k < N; ++k)
        p[k] = k == axisOf(edge) ? levelOf(edge, w) : p[k] + t * d[k];
    return clampedAlong(edge, p, w);
}

} // namespace clipping
