// SPDX-License-Identifier: MIT
//
// Cyrus-Beck (1978), which clips against any convex polygon; here the polygon is the window.
//
//   M. Cyrus, J. Beck: Generalized Two- and Three-Dimensional Clipping.
//   Computers & Graphics 3(1), 1978, 23-28.
//
// Corrected: the inner normals have length 1, so that they exist for a window without height or
// width, and N and D are lengths instead of products of two lengths. A new end takes the coordinate
// of the edge that cut it, and its other coordinates are clamped to the window. In three dimensions
// the edges are the planes of the box.

#include "clipping/algorithms/cyrus_beck.h"

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/part.h"
#include "clipping/polygon/uses.h"

namespace clipping {

struct CyrusBeck {
    static constexpr About about{
        .key = "cyrus-beck",
        .abbreviation = "CB",
        .name = "Cyrus-Beck",
        .year = 1978,
        .idea = "The inner normal of every edge tells whether the segment enters or leaves there; "
                "the visible part lies between the last entry and the first exit.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr const auto* polygon = &cyrusBeckPolygon;
    static constexpr auto line = &cyrusBeckLine;
    static constexpr auto ray = &cyrusBeckRay;

    static constexpr std::string_view publishedCode = R"(
tE = 0,  tL = 1,  dx = x2-x1,  dy = y2-y1  #whole
for each edge, from a corner (xv, yv) to the next one (xw, yw)
  nx = yv-yw,  ny = xw-xv  #normal
  D = nx*dx + ny*dy  #D
  N = nx*(x1-xv) + ny*(y1-yv)  #N
  if D == 0  #parallel
    if N < 0: reject  #outside
  else
    t = -N/D  #t
    if D > 0  #entering
      if t > tE  #later
        tE = t  #start
    else if t < tL  #sooner
      tL = t  #stop
if tE > tL: reject  #missed
if tL < 1  #end2
  x2 = x1 + tL*dx,  y2 = y1 + tL*dy  #move2
if tE > 0  #end1
  x1 = x1 + tE*dx,  y1 = y1 + tE*dy  #move1
accept the line from x1, y1 to x2, y2  #accept
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        T tE = step.set("tE", T(0)), tL = step.set("tL", T(1));
        const T dx = step.set("dx", x2 - x1), dy = step.let("whole", "dy", y2 - y1);
        const std::array<glm::vec<2, T>, 4> corners{
            {w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Edge edge = edgesInTurn[i];
            const auto &from = corners[i], &to = corners[(i + 1) % 4];
            const T xv = step.set("xv", from.x), yv = step.set("yv", from.y);
            const T xw = step.set("xw", to.x), yw = step.set("yw", to.y);
            const T nx = step.set("nx", yv - yw), ny = step.let("normal", "ny", xw - xv, edge);
            const T D = step.let("D", "D", nx * dx + ny * dy, edge);
            const T N = step.let("N", "N", nx * (x1 - xv) + ny * (y1 - yv), edge);
            if (step.test("parallel", D == T(0), edge)) {
                if (step.test("outside", N < T(0), edge))
                    return step.reject("outside");
                continue;
            }
            const T t = step.let("t", "t", -N / D, edge);
            if (step.test("entering", D > T(0), edge)) {
                if (step.test("later", t > tE, edge))
                    tE = step.let("start", "tE", t, edge);
            } else if (step.test("sooner", t < tL, edge))
                tL = step.let("stop", "tL", t, edge);
        }
        if (step.test("missed", tE > tL))
            return step.reject("missed");
        if (step.test("end2", tL < T(1)))
            x2 = x1 + tL * dx, y2 = y1 + tL * dy, step.cut("move2", 1, x2, y2, "tL");
        if (step.test("end1", tE > T(0)))
            x1 = x1 + tE * dx, y1 = y1 + tE * dy, step.cut("move1", 0, x1, y1, "tE");
        return step.accept("accept", BasicSegment<T>{{x1, y1}, {x2, y2}});
    }

    // atEdge(tL) is whether tL is that of an edge, vertical(tL) whether this edge is vertical, and
    // edge(tL) its coordinate. held(v) is v clamped to the window's range on its axis.
    static constexpr std::string_view correctedCode = R"(
tE = 0,  tL = 1,  dx = x2-x1,  dy = y2-y1  #whole
for each edge, with a corner (xv, yv) and an inner normal (nx, ny)
  D = nx*dx + ny*dy  #D
  N = nx*(x1-xv) + ny*(y1-yv)  #N
  if D == 0  #parallel
    if N < 0: reject  #outside
  else
    t = -N/D  #t
    if D > 0  #entering
      if t > tE  #later
        tE = t  #start
    else if t < tL  #sooner
      tL = t  #stop
if tE > tL: reject  #missed
if tL < 1  #end2
  if vertical(tL): x2 = edge(tL),  y2 = held(y1 + tL*dy)  #upright2
  else: x2 = held(x1 + tL*dx),  y2 = edge(tL)  #level2
else
  x2 = held(x2),  y2 = held(y2)  #hold2
if tE > 0  #end1
  if vertical(tE): x1 = edge(tE),  y1 = held(y1 + tE*dy)  #upright1
  else: x1 = held(x1 + tE*dx),  y1 = edge(tE)  #level1
  if atEdge(tL) and tE == tL  #touches
    x1 = x2,  y1 = y2  #contact
else
  x1 = held(x1),  y1 = held(y1)  #hold1
accept the line from x1, y1 to x2, y2  #accept
)";
    template <class T, glm::length_t dimensions, class Step>
    static constexpr std::optional<BasicSegment<T, dimensions>>
    corrected(const BasicSegment<T, dimensions>& s, const BasicWindow<T, dimensions>& w,
              Step&& step)
    {
        Part<T> part{T(0), T(1)};
        step.set("tE", part.start), step.set("tL", part.stop);
        glm::vec<dimensions, T> d;
        for (glm::length_t k = 0; k < dimensions; ++k)
            d[k] = step.let(labelOn(k, "whole", "whole"), extentNames[std::size_t(k)],
                            s.b[k] - s.a[k]);
        for (std::size_t i = 0; i < 2 * std::size_t(dimensions); ++i)
            if (!cutAt(edgesInTurn[i], part, s, d, w, step))
                return std::nullopt;
        if (step.test("missed", part.start > part.stop))
            return step.reject("missed");
        return step.accept("accept", endsOf(part, s, d, w, step));
    }
};

template Algorithm describe<CyrusBeck>();

} // namespace clipping
