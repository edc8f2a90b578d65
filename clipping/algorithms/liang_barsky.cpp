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
  if p < 0  #entering
    r = q/p  #entry
    if r > u1: reject  #tooLate
    else if r > u0  #later
      u0 = r  #start
  else if p > 0  #leaving
    r = q/p  #exit
    if r < u0: reject  #tooEarly
    else if r < u1  #sooner
      u1 = r  #stop
  else if q < 0: reject  #beside
u0 = 0,  u1 = 1,  dx = x2-x1  #whole
if clipt(-dx, x1-xmin)  #atLeft
  if clipt(dx, xmax-x1)  #atRight
    dy = y2-y1  #dy
    if clipt(-dy, y1-ymin)  #atBottom
      if clipt(dy, ymax-y1)  #atTop
        if u1 < 1  #end2
          x2 = x1 + u1*dx,  y2 = y1 + u1*dy  #move2
        if u0 > 0  #end1
          x1 = x1 + u0*dx,  y1 = y1 + u0*dy  #move1
        accept the line from x1, y1 to x2, y2  #accept
)";
    /// The labels of the calls of clipt.
    static constexpr LabelsOfEdges calls{"atLeft", "atRight", "atBottom", "atTop"};

    /// Returns false if nothing is visible.
    template <class T, class Step>
    static constexpr bool clipt(T p, T q, T& u0, T& u1, Edge edge, Step& step)
    {
        step.set("p", p), step.let(labelOf(edge, calls), "q", q, edge);
        if (step.test("entering", p < T(0), edge)) {
            const T r = step.let("entry", "r", q / p, edge);
            if (step.test("tooLate", r > u1, edge)) {
                step.reject("tooLate");
                return false;
            } else if (step.test("later", r > u0, edge))
                u0 = step.let("start", "u0", r, edge);
        } else if (step.test("leaving", p > T(0), edge)) {
            const T r = step.let("exit", "r", q / p, edge);
            if (step.test("tooEarly", r < u0, edge)) {
                step.reject("tooEarly");
                return false;
            } else if (step.test("sooner", r < u1, edge))
                u1 = step.let("stop", "u1", r, edge);
        } else if (step.test("beside", q < T(0), edge)) {
            step.reject("beside");
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
        const T dx = step.let("whole", "dx", x2 - x1);
        if (clipt(-dx, x1 - xmin, u0, u1, Edge::Left, step))
            if (clipt(dx, xmax - x1, u0, u1, Edge::Right, step)) {
                const T dy = step.let("dy", "dy", y2 - y1);
                if (clipt(-dy, y1 - ymin, u0, u1, Edge::Bottom, step))
                    if (clipt(dy, ymax - y1, u0, u1, Edge::Top, step)) {
                        if (step.test("end2", u1 < T(1)))
                            x2 = x1 + u1 * dx, y2 = y1 + u1 * dy,
                            step.cut("move2", 1, x2, y2, "u1");
                        if (step.test("end1", u0 > T(0)))
                            x1 = x1 + u0 * dx, y1 = y1 + u0 * dy,
                            step.cut("move1", 0, x1, y1, "u0");
                        return step.accept("accept", BasicSegment<T>{{x1, y1}, {x2, y2}});
                    }
            }
        return std::nullopt;
    }

    // atEdge(u1) is whether u1 is that of an edge, vertical(u1) whether this edge is vertical, and
    // edge(u1) its coordinate. held(v) is v clamped to the window's range on its axis.
    static constexpr std::string_view correctedCode = R"(
clipt(p, q):
  if p < 0  #entering
    r = q/p  #entry
    if r > u1: reject  #tooLate
    else if r > u0  #later
      u0 = r  #start
  else if p > 0  #leaving
    r = q/p  #exit
    if r < u0: reject  #tooEarly
    else if r < u1  #sooner
      u1 = r  #stop
  else if q < 0: reject  #beside
u0 = 0,  u1 = 1  #whole
dx = x2-x1  #dx
clipt(-dx, x1-xmin)  #atLeft
clipt(dx, xmax-x1)  #atRight
dy = y2-y1  #dy
clipt(-dy, y1-ymin)  #atBottom
clipt(dy, ymax-y1)  #atTop
if u1 < 1  #end2
  if vertical(u1): x2 = edge(u1),  y2 = held(y1 + u1*dy)  #upright2
  else: x2 = held(x1 + u1*dx),  y2 = edge(u1)  #level2
else
  x2 = held(x2),  y2 = held(y2)  #hold2
if u0 > 0  #end1
  if vertical(u0): x1 = edge(u0),  y1 = held(y1 + u0*dy)  #upright1
  else: x1 = held(x1 + u0*dx),  y1 = edge(u0)  #level1
  if atEdge(u1) and u0 == u1  #touches
    x1 = x2,  y1 = y2  #contact
else
  x1 = held(x1),  y1 = held(y1)  #hold1
accept the line from x1, y1 to x2, y2  #accept
)";
    template <class T, glm::length_t N, class Step>
    static constexpr std::optional<BasicSegment<T, N>>
    corrected(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w, Step&& step)
    {
        Part<T> part{T(0), T(1)};
        step.set("u0", part.start), step.let("whole", "u1", part.stop);
        glm::vec<N, T> d;
        for (glm::length_t k = 0; k < N; ++k) {
            d[k] = step.let(labelOn(k, "dx", "dy"), extentNames[std::size_t(k)], s.b[k] - s.a[k]);
            if (!clipping::clipt(-d[k], s.a[k] - w.min[k], part, labelOf(lowerEdge(k), calls),
                                 lowerEdge(k), step)
                || !clipping::clipt(d[k], w.max[k] - s.a[k], part, labelOf(upperEdge(k), calls),
                                    upperEdge(k), step))
                return std::nullopt;
        }
        return step.accept("accept", endsOf(part, s, d, w, step));
    }
};

const Functions<Segment3, Window3> liangBarskyBox = uses<LiangBarsky, Form::Corrected, double, 3>;

template Algorithm describe<LiangBarsky>();

} // namespace clipping
