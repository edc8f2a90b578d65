// SPDX-License-Identifier: MIT
//
// Liang-Barsky's method with the bottom and the top edge first, for windows that are wide and low.

#include "clipping/algorithms/liang_barsky.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/part.h"

namespace clipping {

struct YFirst {
    static constexpr About about{
        .key = "y-first",
        .abbreviation = "YF",
        .name = "y first",
        .year = 2026,
        .idea = "Cut at the bottom and the top edge, then at the left and the right one.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr bool ours = true; // no published form

    static constexpr std::string_view correctedCode = R"(
clipt(p, q):
  if p < 0
    r = q/p
    if r > u1: reject
    else if r > u0
      u0 = r
  else if p > 0
    r = q/p
    if r < u0: reject
    else if r < u1
      u1 = r
  else if q < 0: reject
u0 = 0,  u1 = 1
dy = y2-y1
clipt(-dy, y1-ymin)
clipt(dy, ymax-y1)
dx = x2-x1
clipt(-dx, x1-xmin)
clipt(dx, xmax-x1)
if u1 < 1
  x2 = held(x1 + u1*dx),  y2 = held(y1 + u1*dy)
else
  x2 = held(x2),  y2 = held(y2)
if u0 > 0
  x1 = held(x1 + u0*dx),  y1 = held(y1 + u0*dy)
  if u1 < 1 and u0 == u1
    x1 = x2,  y1 = y2
else
  x1 = held(x1),  y1 = held(y1)
accept the line from x1, y1 to x2, y2
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        Part<T> part{T(0), T(1)};
        step.set("u0", part.start), step.let(13, "u1", part.stop);
        glm::vec<2, T> d;
        for (const glm::length_t k : {1, 0}) {
            const int first = 17 - 3 * k; // first of this axis's three lines
            d[k] = step.let(first, extentNames[std::size_t(k)], s.b[k] - s.a[k]);
            if (!clipt(-d[k], s.a[k] - w.min[k], part, first + 1, lowerEdge(k), step)
                || !clipt(d[k], w.max[k] - s.a[k], part, first + 2, upperEdge(k), step))
                return std::nullopt;
        }
        return step.accept(30, endsOf(part, s, d, w, 20, step));
    }
};

template Algorithm describe<YFirst>();

} // namespace clipping
