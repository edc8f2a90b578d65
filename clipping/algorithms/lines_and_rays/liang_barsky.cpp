// SPDX-License-Identifier: MIT
//
// Liang-Barsky (1984) for infinite lines and rays: the remaining part begins at -infinity or at a,
// and ends at infinity. Steps have the labels of the corrected pseudo-code for segments.

#include "clipping/algorithms/liang_barsky.h"

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
        step.set("u0", part.start), step.let("whole", "u1", part.stop);
        const T dx = step.let("dx", "dx", s.b.x - s.a.x);
        if (!clipt(-dx, s.a.x - w.min.x, part, "atLeft", Edge::Left, step)
            || !clipt(dx, w.max.x - s.a.x, part, "atRight", Edge::Right, step))
            return std::nullopt;
        const T dy = step.let("dy", "dy", s.b.y - s.a.y);
        if (!clipt(-dy, s.a.y - w.min.y, part, "atBottom", Edge::Bottom, step)
            || !clipt(dy, w.max.y - s.a.y, part, "atTop", Edge::Top, step))
            return std::nullopt;
        return step.accept("accept", endsOf<reach>(part, s, {dx, dy}, w, step));
    }
};

} // namespace

const Functions<Line, Window, Segment> liangBarskyLine =
    lineOrRayUses<OnLinesAndRays, Reach::BothWays>;
const Functions<Ray, Window, Segment> liangBarskyRay = lineOrRayUses<OnLinesAndRays, Reach::OneWay>;

} // namespace clipping
