// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/part.h"

namespace clipping {

/// The edges in the order in which Cyrus-Beck tests them: once around the window, then near and
/// far.
inline constexpr std::array edgesInTurn{Edge::Bottom, Edge::Right, Edge::Top,
                                        Edge::Left,   Edge::Near,  Edge::Far};

/// The inner unit normal of an edge.
template <class T, glm::length_t dimensions>
constexpr glm::vec<dimensions, T> innerNormal(Edge edge)
{
    glm::vec<dimensions, T> normal;
    for (glm::length_t k = 0; k < dimensions; ++k)
        normal[k] = T(edge == lowerEdge(k) ? 1 : edge == upperEdge(k) ? -1 : 0);
    return normal;
}

/// A corner on an edge; in the plane the one at which the edge begins, counter-clockwise.
template <class T>
constexpr glm::vec<2, T> cornerOn(Edge edge, const BasicWindow<T>& w)
{
    return {edge == Edge::Right || edge == Edge::Top ? w.max.x : w.min.x,
            edge == Edge::Left || edge == Edge::Top ? w.max.y : w.min.y};
}
template <class T>
constexpr glm::vec<3, T> cornerOn(Edge edge, const BasicWindow<T, 3>& w)
{
    return edge == lowerEdge(axisOf(edge)) ? w.min : w.max;
}

/// The dot product.
template <class T, glm::length_t dimensions>
constexpr T dot(const glm::vec<dimensions, T>& u, const glm::vec<dimensions, T>& v)
{
    T sum = u[0] * v[0];
    for (glm::length_t k = 1; k < dimensions; ++k)
        sum = sum + u[k] * v[k];
    return sum;
}

/// Cuts a part at one edge: one pass of Cyrus and Beck's loop in the corrected pseudo-code; d is
/// b - a. Returns false if nothing is visible.
template <class T, glm::length_t dimensions, class Step>
constexpr bool cutAt(Edge edge, Part<T>& part, const BasicSegment<T, dimensions>& s,
                     const glm::vec<dimensions, T>& d, const BasicWindow<T, dimensions>& w,
                     Step& step)
{
    const auto v = cornerOn(edge, w), n = innerNormal<T, dimensions>(edge);
    step.set("xv", v.x), step.set("yv", v.y), step.set("nx", n.x), step.set("ny", n.y);
    const T D = step.let("D", "D", dot(n, d), edge);
    const T N = step.let("N", "N", dot(n, s.a - v), edge);
    if (step.test("parallel", D == T(0), edge)) {
        if (step.test("outside", N < T(0), edge)) {
            step.reject("outside");
            return false;
        }
    } else {
        const T t = step.let("t", "t", -N / D, edge);
        if (step.test("entering", D > T(0), edge)) {
            if (step.test("later", t > part.start, edge))
                part.start = step.let("start", "tE", t, edge), part.startEdge = edge;
        } else if (step.test("sooner", t < part.stop, edge))
            part.stop = step.let("stop", "tL", t, edge), part.stopEdge = edge;
    }
    return true;
}

} // namespace clipping
