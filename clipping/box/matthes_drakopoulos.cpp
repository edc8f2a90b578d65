// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos in three dimensions, which their paper leaves to future work. Each end is
// moved on one axis after another; if it is still outside afterwards, nothing is visible. In the
// plane, testing this on the x axis alone is enough, because the end is within the window on the y
// axis, on which it was moved last. In n dimensions the test is needed on every axis but the last.
// (With x alone, (0, -1, 0) to (0, 0, -1) would be visible in the unit cube.)
//
// Proof: moving an end on axis k takes its parameter to the nearest one in the interval of axis k.
// The two ends are an interval, at first from 0 to 1; each move replaces it by its intersection
// with the axis's interval or, if that is empty, by a single point. So after all axes either the
// ends are those of the visible part, or both are the same point, which is within the last axis's
// interval but outside another one.
//
// Steps have the labels of the corrected pseudo-code for the plane.

#include "clipping/box/moving_end.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

namespace clipping {
namespace {

struct MatthesDrakopoulosBox {
    static constexpr LabelsOfEdges cuts{"toLeft", "toRight", "toBottom", "toTop"};

    /// Moves end number `end` to the sides it is beyond.
    template <class T, class Step>
    static constexpr void push(int end, MovingEnd<T>& moving, Step& step)
    {
        for (glm::length_t k = 0; k < 3; ++k) {
            const Edge side = moving.isBelow(k)   ? lowerEdge(k)
                              : moving.isAbove(k) ? upperEdge(k)
                                                  : Edge::NoEdge;
            if (side == Edge::NoEdge)
                continue;
            moving.moveTo(side);
            step.cut(labelOf(side, cuts), end, moving.at(), side);
        }
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T, 3>>
    corrected(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Step&& step)
    {
        for (glm::length_t k = 0; k < 3; ++k)
            if (step.test(labelOn(k, "besideX", "besideY"),
                          (s.a[k] < w.min[k] && s.b[k] < w.min[k])
                              || (s.a[k] > w.max[k] && s.b[k] > w.max[k]),
                          lowerEdge(k), upperEdge(k)))
                return step.reject(labelOn(k, "rejectX", "rejectY"));
        const glm::vec<3, T> d{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
        MovingEnd<T> a(s.a, d, w), b(s.b, d, w);
        push(0, a, step);
        push(1, b, step);
        constexpr glm::length_t lastAxis = 2; // not tested
        for (glm::length_t k = 0; k < lastAxis; ++k)
            if (step.test("missed",
                          (a.isBelow(k) && b.isBelow(k)) || (a.isAbove(k) && b.isAbove(k)),
                          lowerEdge(k), upperEdge(k)))
                return step.reject("reject");
        const BasicSegment<T, 3> visible = between(a, b);
        step.left("hold", visible);
        return step.accept("accept", visible);
    }
};

} // namespace

const Functions<Segment3, Window3> matthesDrakopoulosBox =
    uses<MatthesDrakopoulosBox, Form::Corrected, double, 3>;

} // namespace clipping
