// SPDX-License-Identifier: MIT
//
// Skala (2005) for infinite lines and rays. A line has no end with an outcode, a ray has one; at
// infinity there is always a cut. Steps have the labels of the corrected pseudo-code for
// segments.

#include "clipping/algorithms/skala.h"

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"
#include "clipping/part.h"

namespace clipping {
namespace {

struct OnLinesAndRays {
    /// Whether a ray begins beyond an edge and does not approach it.
    template <class T>
    static constexpr bool missed(unsigned code, const BasicSegment<T>& s)
    {
        return ((code & outcode::left) && s.b.x <= s.a.x)
               || ((code & outcode::right) && s.b.x >= s.a.x)
               || ((code & outcode::bottom) && s.b.y <= s.a.y)
               || ((code & outcode::top) && s.b.y >= s.a.y);
    }

    template <Reach reach, class T, class Step>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Step&& step)
    {
        bool isCut = true; // whether End 1 is cut
        if constexpr (reach == Reach::OneWay) {
            const unsigned code = step.let("codes", "code1", outcodeOf(s.a, w));
            if (step.test("beyond", missed(code, s)))
                return step.reject("rejectBeyond");
            isCut = code != 0;
        }
        const auto crossing = crossingOf(s, w, step);
        if (!crossing)
            return std::nullopt;
        BasicSegment<T> visible{s.a, crossedAt(crossing->j, *crossing, s.a, w)};
        const Edge leave = edgesFromCorners[crossing->j], enter = edgesFromCorners[crossing->i];
        step.cut(labelAt(leave, "upright2", "level2"), 1, visible.b, leave);
        if (reach == Reach::BothWays || step.test("end1", isCut)) {
            visible.a = crossedAt(crossing->i, *crossing, s.a, w);
            step.cut(labelAt(enter, "upright1", "level1"), 0, visible.a, enter);
        }
        return step.accept("accept", visible);
    }
};

} // namespace

const Functions<Line, Window, Segment> skalaLine = lineOrRayUses<OnLinesAndRays, Reach::BothWays>;
const Functions<Ray, Window, Segment> skalaRay = lineOrRayUses<OnLinesAndRays, Reach::OneWay>;

} // namespace clipping
