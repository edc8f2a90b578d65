// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

namespace clipping {

/// The edge of the window on which a new end lies.
template <class T, glm::length_t N>
constexpr Edge edgeAt(const glm::vec<N, T>& p, const BasicWindow<T, N>& w)
{
    for (glm::length_t k = 0; k < N; ++k)
        if (p[k] == w.min[k])
            return lowerEdge(k);
        else if (p[k] == w.max[k])
            return upperEdge(k);
    return Edge::NoEdge;
}

/// The `cut` value of a piece: which of its ends differ from those of `whole`, and the edges they
/// lie on.
template <class T, glm::length_t N>
constexpr std::uint32_t cutOf(const BasicSegment<T, N>& whole, const BasicSegment<T, N>& piece,
                              const BasicWindow<T, N>& w)
{
    return cutAt(piece.a == whole.a ? Edge::NoEdge : edgeAt(piece.a, w),
                 piece.b == whole.b ? Edge::NoEdge : edgeAt(piece.b, w));
}

/// Whether a segment, or the line through it, can meet the window in at most one point, because it
/// crosses a window without height, width or depth.
template <class T, glm::length_t N>
constexpr bool meetsInAPoint(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w)
{
    for (glm::length_t k = 0; k < N; ++k)
        if (w.min[k] == w.max[k] && s.a[k] != s.b[k])
            return true;
    return false;
}

} // namespace clipping
