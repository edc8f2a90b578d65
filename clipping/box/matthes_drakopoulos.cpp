// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos in three dimensions, which their paper leaves to the future: each end is
// pushed on one axis after another, and what is then still outside was never inside. In the plane
// asking that on the x axis alone is enough, as the end is within the other, on which it was pushed
// last; carried over to n dimensions it takes the question on every axis but the last. (On x alone
// (0, -1, 0) to (0, 0, -1) would be visible in the unit cube.)
//
// Why: a push on axis k takes the parameter of an end to the nearest one in the interval of axis k.
// Both ends together are the interval from 0 to 1, and a push makes of it what it has in common
// with the axis's interval, or, if that is nothing, a single point. So after all axes either the
// ends are those of the visible part, or both are one point, in reach of the last axis but not of
// another.
//
// The lines of the steps are those of the corrected pseudo-code for the plane, which has none for
// near and far.

#include "clipping/box/moving_end.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

struct MatthesDrakopoulosBox {
    static constexpr int lineOf(Edge side)
    {
        return side < Edge::Near ? 7 + 3 * static_cast<int>(side) : 0; // 10, 13, 16, 19
    }

    /// Pushes end number `end` to the sides it is beyond.
    template <class T, class Step>
    static constexpr void push(int end, MovingEnd<T>& moving, Step& step)
    {
        for (glm::length_t k = 0; k < 3; ++k) {
            const Edge side = moving.isBelow(k)   ? lowerEdge(k)
                              : moving.isAbove(k) ? upperEdge(k)
                                                  : Edge::None;
            if (side == Edge::None)
                continue;
            moving.moveTo(side);
            step.cut(lineOf(side), end, moving.at(), side);
        }
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T, 3>>
    corrected(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Step&& step)
    {
        for (glm::length_t k = 0; k < 3; ++k)
            if (step.test(k < 2 ? 1 + 2 * k : 0,
                          (s.a[k] < w.min[k] && s.b[k] < w.min[k])
                              || (s.a[k] > w.max[k] && s.b[k] > w.max[k]),
                          lowerEdge(k), upperEdge(k)))
                return step.reject(k < 2 ? 2 + 2 * k : 0);
        const glm::vec<3, T> d{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
        MovingEnd<T> a(s.a, d, w), b(s.b, d, w);
        push(0, a, step);
        push(1, b, step);
        constexpr glm::length_t lastAxis = 2; // no question there
        for (glm::length_t k = 0; k < lastAxis; ++k)
            if (step.test(20, (a.isBelow(k) && b.isBelow(k)) || (a.isAbove(k) && b.isAbove(k)),
                          lowerEdge(k), upperEdge(k)))
                return step.reject(21);
        const BasicSegment<T, 3> visible = between(a, b);
        step.left(22, visible);
        return step.accept(23, visible);
    }
};

} // namespace

const Uses<Segment3, Window3> matthesDrakopoulosBox =
    uses<MatthesDrakopoulosBox, Form::Corrected, double, 3>;

} // namespace clipping
