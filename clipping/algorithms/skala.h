// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"

#include <array>
#include <optional>

namespace clipping {

/// Skala's edges e0 to e3, counter-clockwise; edge k joins corner k to the next. Corner 0 is
/// (xmin, ymin).
inline constexpr std::array edgesFromCorners{Edge::Bottom, Edge::Right, Edge::Top, Edge::Left};

/// The edges at which a line enters and leaves the window.
struct Passage {
    int enter, leave;
};
/// Indexed by the pattern of corners on the line's left: bit k is for corner k. 0 and 15 are
/// rejected before; 5 and 10 cannot occur, because rounding keeps the products in order.
// clang-format off
inline constexpr std::array<Passage, 16> passages{{
    {}, {0, 3}, {1, 0}, {1, 3},
    {2, 1}, {}, {2, 0}, {2, 3},
    {3, 2}, {0, 2}, {}, {1, 2},
    {3, 1}, {0, 1}, {3, 0}, {},
}};
// clang-format on

/// A line that crosses the window.
template <class T>
struct Crossing {
    glm::vec<2, T> d;   ///< b - a
    std::array<T, 4> f; ///< for edge k: dx or dy times the distance from a to the edge
    int i, j;           ///< the edges at which it enters and leaves
};

/// The edges that the line through a segment crosses: a part of the corrected pseudo-code.
/// With the origin at a the line is dx*y = dy*x, so comparing the products of a corner's two edges
/// gives the corner's side.
template <class T, class Step>
constexpr std::optional<Crossing<T>> crossingOf(const BasicSegment<T>& s, const BasicWindow<T>& w,
                                                Step& step)
{
    const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
    const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
    const T dx = step.set("dx", x2 - x1), dy = step.let("line", "dy", y2 - y1);
    const std::array f{
        step.set("f[0]", dx * (ymin - y1)), step.let("f01", "f[1]", dy * (xmax - x1)),
        step.set("f[2]", dx * (ymax - y1)), step.let("f23", "f[3]", dy * (xmin - x1))};
    int c0 = step.let("c0", "c[0]", f[0] >= f[3] ? 1 : 0);
    int c1 = step.let("c1", "c[1]", f[0] >= f[1] ? 1 : 0);
    int c2 = step.let("c2", "c[2]", f[2] >= f[1] ? 1 : 0);
    int c3 = step.let("c3", "c[3]", f[2] >= f[3] ? 1 : 0);
    auto c = step.let("pattern", "c", unsigned(c0 + 2 * c1 + 4 * c2 + 8 * c3));
    // Corners on the line counted as left; now they count as right.
    if (step.test("allLeft", c == 0b1111)) {
        c0 = step.let("strict0", "c[0]", f[0] > f[3] ? 1 : 0);
        c1 = step.let("strict1", "c[1]", f[0] > f[1] ? 1 : 0);
        c2 = step.let("strict2", "c[2]", f[2] > f[1] ? 1 : 0);
        c3 = step.let("strict3", "c[3]", f[2] > f[3] ? 1 : 0);
        c = step.let("strictPattern", "c", unsigned(c0 + 2 * c1 + 4 * c2 + 8 * c3));
        if (step.test("flat", c == 0b0000)) { // the whole window, which has no area, is on the line
            c = step.let("flatPattern", "c",
                         dx > T(0)   ? 0b1100U
                         : dx < T(0) ? 0b0011U
                         : dy > T(0) ? 0b1001U
                                     : 0b0110U);
        }
    }
    if (step.test("missed", c == 0b0000 || c == 0b1111))
        return step.reject("reject");
    const auto [i, j] = passages[c];
    step.set("enter[c]", i), step.set("leave[c]", j);
    step.set("i", i), step.let("edges", "j", j);
    return Crossing<T>{{dx, dy}, f, i, j};
}

/// The point where the line through a crosses edge k: one coordinate is the edge's own, the other
/// is clamped to the window.
template <class T>
constexpr glm::vec<2, T> crossedAt(int k, const Crossing<T>& line, const glm::vec<2, T>& a,
                                   const BasicWindow<T>& w)
{
    const T product = line.f[k];
    return clampedAlong(edgesFromCorners[k],
                        k % 2 == 0
                            ? glm::vec<2, T>{a.x + product / line.d.y, k == 0 ? w.min.y : w.max.y}
                            : glm::vec<2, T>{k == 1 ? w.max.x : w.min.x, a.y + product / line.d.x},
                        w);
}

} // namespace clipping
