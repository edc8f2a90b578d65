// SPDX-License-Identifier: MIT
//
// Cyrus-Beck (1978) for infinite lines and rays: the remaining part begins at -infinity or at a,
// and ends at infinity. Steps have the labels of the corrected pseudo-code for segments.

#include "clipping/algorithms/cyrus_beck.h"

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/part.h"

namespace clipping {
namespace {

struct OnLinesAndRays {
    template <Reach reach, class T, class Step>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Step&& step)
    {
        Part<T> part{beginning<reach, T>(), ending<reach, T>()};
        step.set("tE", part.start), step.set("tL", part.stop);
        const T dx = step.let("whole", "dx", s.b.x - s.a.x),
                dy = step.let("whole", "dy", s.b.y - s.a.y);
        for (const Edge edge : {Edge::Bottom, Edge::Right, Edge::Top, Edge::Left})
            if (!cutAt(edge, part, s, {dx, dy}, w, step))
                return std::nullopt;
        if (step.test("missed", part.start > part.stop))
            return step.reject("missed");
        return step.accept("accept", endsOf<reach>(part, s, {dx, dy}, w, step));
    }
};

} // namespace

const Functions<Line, Window, Segment> cyrusBeckLine =
    lineOrRayUses<OnLinesAndRays, Reach::BothWays>;
const Functions<Ray, Window, Segment> cyrusBeckRay = lineOrRayUses<OnLinesAndRays, Reach::OneWay>;

} // namespace clipping
