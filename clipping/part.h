// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/along.h"
#include "clipping/labels.h"
#include "clipping/line_or_ray.h"

#include <array>
#include <string_view>

namespace clipping {

/// The remaining part of a segment, from `start` to `stop` (0 at a, 1 at b), and the edges that cut
/// it there.
template <class T>
struct Part {
    T start, stop;
    Edge startEdge = Edge::NoEdge, stopEdge = Edge::NoEdge;
};

/// The pseudo-codes' names of b - a on each axis.
inline constexpr std::array<std::string_view, 3> extentNames{"dx", "dy", "dz"};

/// The segment of a part of `s`; d is b - a. The steps are twelve lines of pseudo-code. atEdge(u)
/// is whether u is that of an edge, vertical(u) whether this edge is vertical, and edge(u) its
/// coordinate:
///
///     if stop < 1  #end2
///       if vertical(stop): x2 = edge(stop),  y2 = held(y1 + stop*dy)  #upright2
///       else: x2 = held(x1 + stop*dx),  y2 = edge(stop)  #level2
///     else
///       x2 = held(x2),  y2 = held(y2)  #hold2
///     if start > 0  #end1
///       if vertical(start): x1 = edge(start),  y1 = held(y1 + start*dy)  #upright1
///       else: x1 = held(x1 + start*dx),  y1 = edge(start)  #level1
///       if atEdge(stop) and start == stop  #touches
///         x1 = x2,  y1 = y2  #contact
///     else
///       x1 = held(x1),  y1 = held(y1)  #hold1
///
/// The far end of a ray and both ends of an infinite line are always cut, without a test.
template <Reach reach = Reach::Bounded, class T, glm::length_t N, class Step>
constexpr BasicSegment<T, N> endsOf(const Part<T>& part, const BasicSegment<T, N>& s,
                                    const glm::vec<N, T>& d, const BasicWindow<T, N>& w, Step& step)
{
    BasicSegment<T, N> visible = s;
    if (reach != Reach::Bounded || step.test("end2", part.stop < T(1), part.stopEdge)) {
        visible.b = along(s, d, part.stop, part.stopEdge, w);
        step.cut(labelAt(part.stopEdge, "upright2", "level2"), 1, visible.b, part.stopEdge);
    } else {
        visible.b = clamped(s.b, w);
        step.left("hold2", visible);
    }
    if (reach == Reach::BothWays || step.test("end1", part.start > T(0), part.startEdge)) {
        visible.a = along(s, d, part.start, part.startEdge, w);
        step.cut(labelAt(part.startEdge, "upright1", "level1"), 0, visible.a, part.startEdge);
        if (step.test("touches", part.stopEdge != Edge::NoEdge && part.start == part.stop)) {
            visible.a = visible.b; // a single common point
            step.cut("contact", 0, visible.a, part.startEdge);
        }
    } else {
        visible.a = clamped(s.a, w);
        step.left("hold1", visible);
    }
    return visible;
}

} // namespace clipping
