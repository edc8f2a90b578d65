// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/algorithm.h"
#include "clipping/clamped.h"

namespace clipping {

/// The point of a segment at t (0 at a, 1 at b), where it meets `edge`; (dx, dy) is b - a.
/// Corrected: one coordinate is the edge's own, the other is held inside the window.
template <Form form, class T>
constexpr glm::vec<2, T> along(const BasicSegment<T>& s, T dx, T dy, T t, Edge edge,
                               const BasicWindow<T>& w)
{
    if constexpr (form == Form::Published)
        return {s.a.x + t * dx, s.a.y + t * dy};
    else if (edge == Edge::Left || edge == Edge::Right)
        return clampedAlong(edge, {edge == Edge::Left ? w.min.x : w.max.x, s.a.y + t * dy}, w);
    else
        return clampedAlong(edge, {s.a.x + t * dx, edge == Edge::Bottom ? w.min.y : w.max.y}, w);
}

} // namespace clipping
