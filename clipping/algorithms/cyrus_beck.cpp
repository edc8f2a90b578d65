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
tE = 0,  tL = 1,  dx = x2-x1,  dy = y2-y1
for each edge, from a corner (xv, yv) to the next one (xw, yw)
  nx = yv-yw,  ny = xw-xv
  D = nx*dx + ny*dy
  N = nx*(x1-xv) + ny*(y1-yv)
  if D == 0
    if N < 0: reject
  else
    t = -N/D
    if D > 0
      if t > tE
        tE = t
    else if t < tL
      tL = t
if tE > tL: reject
if tL < 1
  x2 = x1 + tL*dx,  y2 = y1 + tL*dy
if tE > 0
  x1 = x1 + tE*dx,  y1 = y1 + tE*dy
accept the line from x1, y1 to x2, y2
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        T tE = step.set("tE", T(0)), tL = step.set("tL", T(1));
        const T dx = step.set("dx", x2 - x1), dy = step.let(1, "dy", y2 - y1);
        const std::array<glm::vec<2, T>, 4> corners{
            {w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const Edge edge = edgesInTurn[i];
            const auto &from = corners[i], &to = corners[(i + 1) % 4];
            const T xv = step.set("xv", from.x), yv = step.set("yv", from.y);
            const T xw = step.set("xw", to.x), yw = step.set("yw", to.y);
            const T nx = step.set("nx", yv - yw), ny = step.let(3, "ny", xw - xv, edge);
            const T D = step.let(4, "D", nx * dx + ny * dy, edge);
            const T N = step.let(5, "N", nx * (x1 - xv) + ny * (y1 - yv), edge);
            if (step.test(6, D == T(0), edge)) {
                if (step.test(7, N < T(0), edge))
                    return step.reject(7);
                continue;
            }
            const T t = step.let(9, "t", -N / D, edge);
            if (step.test(10, D > T(0), edge)) {
                if (step.test(11, t > tE, edge))
                    tE = step.let(12, "tE", t, edge);
            } else if (step.test(13, t < tL, edge))
                tL = step.let(14, "tL", t, edge);
        }
        if (step.test(15, tE > tL))
            return step.reject(15);
        if (step.test(16, tL < T(1)))
            x2 = x1 + tL * dx, y2 = y1 + tL * dy, step.cut(17, 1, x2, y2, "tL");
        if (step.test(18, tE > T(0)))
            x1 = x1 + tE * dx, y1 = y1 + tE * dy, step.cut(19, 0, x1, y1, "tE");
        return step.accept(20, BasicSegment<T>{{x1, y1}, {x2, y2}});
    }

    // atEdge(tL) is whether tL is that of an edge, vertical(tL) whether this edge is vertical, and
    // edge(tL) its coordinate. held(v) is v clamped to the window's range on its axis.
    static constexpr std::string_view correctedCode = R"(
tE = 0,  tL = 1,  dx = x2-x1,  dy = y2-y1
for each edge, with a corner (xv, yv) and an inner normal (nx, ny)
  D = nx*dx + ny*dy
  N = nx*(x1-xv) + ny*(y1-yv)
  if D == 0
    if N < 0: reject
  else
    t = -N/D
    if D > 0
      if t > tE
        tE = t
    else if t < tL
      tL = t
if tE > tL: reject
if tL < 1
  if vertical(tL): x2 = edge(tL),  y2 = held(y1 + tL*dy)
  else: x2 = held(x1 + tL*dx),  y2 = edge(tL)
else
  x2 = held(x2),  y2 = held(y2)
if tE > 0
  if vertical(tE): x1 = edge(tE),  y1 = held(y1 + tE*dy)
  else: x1 = held(x1 + tE*dx),  y1 = edge(tE)
  if atEdge(tL) and tE == tL
    x1 = x2,  y1 = y2
else
  x1 = held(x1),  y1 = held(y1)
accept the line from x1, y1 to x2, y2
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
            d[k] = step.let(lineOn(k, 1), extentNames[std::size_t(k)], s.b[k] - s.a[k]);
        for (std::size_t i = 0; i < 2 * std::size_t(dimensions); ++i)
            if (!cutAt(edgesInTurn[i], part, s, d, w, step))
                return std::nullopt;
        if (step.test(14, part.start > part.stop))
            return step.reject(14);
        return step.accept(27, endsOf(part, s, d, w, 15, step));
    }
};

template Algorithm describe<CyrusBeck>();

} // namespace clipping
