// SPDX-License-Identifier: MIT
//
// Liang-Barsky (1984).
//
//   Y.-D. Liang, B. A. Barsky: A New Concept and Method for Line Clipping.
//   ACM Transactions on Graphics 3(1), 1984, 1-22.
//
// Published: the paper's procedure. Corrected: a new end takes the coordinate of the edge that cut
// it, and its other coordinates are clamped to the window; a single common point is the same point
// at both ends.

#include "clipping/algorithms/liang_barsky.h"

#include "clipping/algorithms/best.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/part.h"

namespace clipping {

struct LiangBarsky {
    static constexpr About about{
        .key = "liang-barsky",
        .abbreviation = "LB",
        .name = "Liang-Barsky",
        .year = 1984,
        .idea = "Start with the parameter interval from 0 to 1; each edge raises its start or "
                "lowers its end.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr auto line = &liangBarskyLine;
    static constexpr auto ray = &liangBarskyRay;

    static constexpr std::string_view publishedCode = R"(
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
u0 = 0,  u1 = 1,  dx = x2-x1
if clipt(-dx, x1-xmin)
  if clipt(dx, xmax-x1)
    dy = y2-y1
    if clipt(-dy, y1-ymin)
      if clipt(dy, ymax-y1)
        if u1 < 1
          x2 = x1 + u1*dx,  y2 = y1 + u1*dy
        if u0 > 0
          x1 = x1 + u0*dx,  y1 = y1 + u0*dy
        accept the line from x1, y1 to x2, y2
)";
    // Pseudo-code lines of the calls of clipt, by edge.
    static constexpr std::array callLines{0, 14, 15, 17, 18};

    /// Returns false if nothing is visible.
    template <class T, class Step>
    static constexpr bool clipt(T p, T q, T& u0, T& u1, Edge edge, Step& step)
    {
        step.set("p", p), step.let(callLines[std::size_t(edge)], "q", q, edge);
        if (step.test(2, p < T(0), edge)) {
            const T r = step.let(3, "r", q / p, edge);
            if (step.test(4, r > u1, edge)) {
                step.reject(4);
                return false;
            } else if (step.test(5, r > u0, edge))
                u0 = step.let(6, "u0", r, edge);
        } else if (step.test(7, p > T(0), edge)) {
            const T r = step.let(8, "r", q / p, edge);
            if (step.test(9, r < u0, edge)) {
                step.reject(9);
                return false;
            } else if (step.test(10, r < u1, edge))
                u1 = step.let(11, "u1", r, edge);
        } else if (step.test(12, q < T(0), edge)) {
            step.reject(12);
            return false;
        }
        return true;
    }
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        T u0 = step.set("u0", T(0)), u1 = step.set("u1", T(1));
        const T dx = step.let(13, "dx", x2 - x1);
        if (clipt(-dx, x1 - xmin, u0, u1, Edge::Left, step))
            if (clipt(dx, xmax - x1, u0, u1, Edge::Right, step)) {
                const T dy = step.let(16, "dy", y2 - y1);
                if (clipt(-dy, y1 - ymin, u0, u1, Edge::Bottom, step))
                    if (clipt(dy, ymax - y1, u0, u1, Edge::Top, step)) {
                        if (step.test(19, u1 < T(1)))
                            x2 = x1 + u1 * dx, y2 = y1 + u1 * dy, step.cut(20, 1, x2, y2, "u1");
                        if (step.test(21, u0 > T(0)))
                            x1 = x1 + u0 * dx, y1 = y1 + u0 * dy, step.cut(22, 0, x1, y1, "u0");
                        return step.accept(23, BasicSegment<T>{{x1, y1}, {x2, y2}});
                    }
            }
        return std::nullopt;
    }

    // atEdge(u1) is whether u1 is that of an edge, vertical(u1) whether this edge is vertical, and
    // edge(u1) its coordinate. held(v) is v clamped to the window's range on its axis.
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
dx = x2-x1
clipt(-dx, x1-xmin)
clipt(dx, xmax-x1)
dy = y2-y1
clipt(-dy, y1-ymin)
clipt(dy, ymax-y1)
if u1 < 1
  if vertical(u1): x2 = edge(u1),  y2 = held(y1 + u1*dy)
  else: x2 = held(x1 + u1*dx),  y2 = edge(u1)
else
  x2 = held(x2),  y2 = held(y2)
if u0 > 0
  if vertical(u0): x1 = edge(u0),  y1 = held(y1 + u0*dy)
  else: x1 = held(x1 + u0*dx),  y1 = edge(u0)
  if atEdge(u1) and u0 == u1
    x1 = x2,  y1 = y2
else
  x1 = held(x1),  y1 = held(y1)
accept the line from x1, y1 to x2, y2
)";
    template <class T, glm::length_t N, class Step>
    static constexpr std::optional<BasicSegment<T, N>>
    corrected(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w, Step&& step)
    {
        Part<T> part{T(0), T(1)};
        step.set("u0", part.start), step.let(13, "u1", part.stop);
        glm::vec<N, T> d;
        for (glm::length_t k = 0; k < N; ++k) {
            const int first = 14 + 3 * k; // first of this axis's three lines
            d[k] = step.let(lineOn(k, first), extentNames[std::size_t(k)], s.b[k] - s.a[k]);
            if (!clipping::clipt(-d[k], s.a[k] - w.min[k], part, lineOn(k, first + 1), lowerEdge(k),
                                 step)
                || !clipping::clipt(d[k], w.max[k] - s.a[k], part, lineOn(k, first + 2),
                                    upperEdge(k), step))
                return std::nullopt;
        }
        return step.accept(32, endsOf(part, s, d, w, 20, step));
    }
};

const Functions<Segment3, Window3> liangBarskyBox = uses<LiangBarsky, Form::Corrected, double, 3>;

template Algorithm describe<LiangBarsky>();

} // namespace clipping
