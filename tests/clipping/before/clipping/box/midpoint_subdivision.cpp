// SPDX-License-Identifier: MIT
//
// Midpoint subdivision in three dimensions, as the row's corrected form does it in the plane:
// points are whole multiples of 2^-53 of the segment, and their outcodes (of six bits) compare the
// way from a with the ways to the sides. Where the last two points are outside for different
// reasons, or both ends are found within a step of each other, the segment touches the box in a
// point.
//
// How far off: a step is e*D, 2 units; an outcode is wrong within 3e, 6 units; the way from a, and
// adding it, 5. So k is far below that of README.md, "Boxes". The lines of the steps are those of
// the pseudo-code for the plane.

#include "clipping/box/uses.h"
#include "clipping/describe.h"
#include "clipping/halving.h"
#include "clipping/outcode.h"

#include <bit>

namespace clipping {
namespace {

struct MidpointSubdivisionBox {
    static constexpr Edge sideOf(unsigned code)
    {
        return static_cast<Edge>(std::countr_zero(code) + 1);
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        if ((codeA & codeB) != 0) {
            watch("reject", 2, s, Edge::None);
            return std::nullopt;
        }
        const Fractions<T, 3> points(s, w);
        BasicSegment<T, 3> visible = s;
        std::optional<Bracket<T>> last, first;
        const auto cut = [&](const Bracket<T>& bracket, int line, auto& end) {
            const auto found = halved<Form::Corrected>(points, bracket, watch);
            if (found) {
                end = points.at(found->near, found->codes());
                watch("cut", line, visible, sideOf(found->farCode));
            }
            return found;
        };
        if ((codeB != 0 && !(last = cut({T(0), T(1), codeA, codeB}, 4, visible.b)))
            || (codeA != 0 && !(first = cut({T(1), T(0), codeB, codeA}, 6, visible.a))))
            return std::nullopt;
        if (first && last && points.areNeighbours(first->near, last->near)) {
            const auto touch = points.at(last->near, last->codes() | first->codes());
            visible = {touch, touch};
        }
        watch("accept", 7, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> midpointSubdivisionBox =
    uses<MidpointSubdivisionBox, Form::Corrected, double, 3>;

} // namespace clipping
