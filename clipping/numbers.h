// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"
#include "clipping/wide.h"

namespace clipping {

/// Converts doubles exactly to another number type of the library: Wide, or Counted of Wide or
/// double.
template <class T>
glm::vec<2, T> pointIn(const glm::dvec2& p)
{
    return {T(p.x), T(p.y)};
}
template <class T>
BasicSegment<T> segmentIn(const Segment& s)
{
    return {pointIn<T>(s.a), pointIn<T>(s.b)};
}
template <class T>
BasicWindow<T> windowIn(const Window& w)
{
    return {pointIn<T>(w.min), pointIn<T>(w.max)};
}

} // namespace clipping
