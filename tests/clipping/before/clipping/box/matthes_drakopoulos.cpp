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
// The lines of the steps are those of the pseudo-code for the plane, which has none for near and
// far.

#include "clipping/box/moving_end.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"

namespace clipping {
namespace {

struct MatthesDrakopoulosBox {
    static constexpr int lineOf(Edge side)
    {
        return side < Edge::Near ? 6 + 3 * static_cast<int>(side) : 0; // 9, 12, 15, 18
    }

    /// Pushes `moving` to the sides it is beyond; `end` is which end of `visible` it is.
    template <class T, class Watch>
    static constexpr void push(MovingEnd<T>& moving, glm::vec<3, T> BasicSegment<T, 3>::*end,
                               BasicSegment<T, 3>& visible, Watch& watch)
    {
        for (glm::length_t k = 0; k < 3; ++k) {
            const Edge side = moving.isBelow(k)   ? lowerEdge(k)
                              : moving.isAbove(k) ? upperEdge(k)
                                                  : Edge::None;
            if (side == Edge::None)
                continue;
            moving.moveTo(side);
            visible.*end = moving.at();
            watch("cut", lineOf(side), visible, side);
        }
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        for (glm::length_t k = 0; k < 3; ++k)
            if ((s.a[k] < w.min[k] && s.b[k] < w.min[k])
                || (s.a[k] > w.max[k] && s.b[k] > w.max[k])) {
                watch("reject", k < 2 ? 2 + 2 * k : 0, s, Edge::None);
                return std::nullopt;
            }
        const glm::vec<3, T> d{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
        MovingEnd<T> a(s.a, d, w), b(s.b, d, w);
        BasicSegment<T, 3> visible = s;
        push(a, &BasicSegment<T, 3>::a, visible, watch);
        push(b, &BasicSegment<T, 3>::b, visible, watch);
        constexpr glm::length_t lastAxis = 2; // no question there
        for (glm::length_t k = 0; k < lastAxis; ++k)
            if ((a.isBelow(k) && b.isBelow(k)) || (a.isAbove(k) && b.isAbove(k))) {
                watch("reject", 20, visible, Edge::None);
                return std::nullopt;
            }
        visible = between(a, b);
        watch("accept", 21, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> matthesDrakopoulosBox =
    uses<MatthesDrakopoulosBox, Form::Corrected, double, 3>;

} // namespace clipping
