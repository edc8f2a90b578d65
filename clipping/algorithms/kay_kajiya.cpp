// SPDX-License-Identifier: MIT
//
// Kay-Kajiya (1986): the slabs of ray tracing, for a segment.
//
//   T. L. Kay, J. T. Kajiya: Ray Tracing Complex Scenes. Computer Graphics 20(4), SIGGRAPH 1986,
//   269-278.
//
// Published is the method as textbooks print it, of a segment in place of a ray. Corrected: a new
// end takes the coordinate of the edge that cut it, and its other coordinate is held inside the
// window; a single common point is the same point at both ends.

#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/part.h"

namespace clipping {

struct KayKajiya {
    static constexpr About about{
        .key = "kay-kajiya",
        .abbreviation = "KK",
        .name = "Kay-Kajiya",
        .year = 1986,
        .idea = "A window is where two slabs meet: keep what lies between each pair of edges.",
        .ulps = 24, // README.md, "How far off"
    };

    static constexpr std::array callLines{15, 17}; // of slab, by the axis

    /// Keeps of a part what lies between two edges, from `low` to `high` on the axis k, where the
    /// segment goes from p by d. False: nothing is left.
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): the four arguments of the pseudo-code and the rest
    static constexpr bool slab(T p, T d, T low, T high, Part<T>& part, glm::length_t k, Step& step)
    {
        const int call = k < 2 ? callLines[std::size_t(k)] : 0;
        step.set("p", p), step.set("d", d), step.set("low", low), step.let(call, "high", high);
        if (step.test(2, d == T(0))) {
            if (step.test(3, p < low || p > high, lowerEdge(k), upperEdge(k))) {
                step.reject(3);
                return false;
            }
            return true;
        }
        T t1 = step.set("t1", (low - p) / d), t2 = step.let(5, "t2", (high - p) / d);
        Edge first = lowerEdge(k), last = upperEdge(k);
        if (step.test(6, t1 > t2)) {
            const T t = step.set("t", t1);
            t1 = step.set("t1", t2), t2 = step.let(7, "t2", t);
            std::swap(first, last);
        }
        if (step.test(8, t1 > part.start, first))
            part.start = step.let(9, "near", t1, first), part.startEdge = first;
        if (step.test(10, t2 < part.stop, last))
            part.stop = step.let(11, "far", t2, last), part.stopEdge = last;
        if (step.test(12, part.start > part.stop)) {
            step.reject(12);
            return false;
        }
        return true;
    }

    static constexpr std::string_view publishedCode = R"(
slab(p, d, low, high):
  if d == 0
    if p < low or p > high: reject
  else
    t1 = (low-p)/d,  t2 = (high-p)/d
    if t1 > t2
      t = t1,  t1 = t2,  t2 = t
    if t1 > near
      near = t1
    if t2 < far
      far = t2
    if near > far: reject
near = 0,  far = 1
dx = x2-x1
slab(x1, dx, xmin, xmax)
dy = y2-y1
slab(y1, dy, ymin, ymax)
if far < 1
  x2 = x1 + far*dx,  y2 = y1 + far*dy
if near > 0
  x1 = x1 + near*dx,  y1 = y1 + near*dy
accept the line from x1, y1 to x2, y2
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        Part<T> part{T(0), T(1)};
        step.set("near", part.start), step.let(13, "far", part.stop);
        const T dx = step.let(14, "dx", x2 - x1);
        if (!slab(x1, dx, w.min.x, w.max.x, part, 0, step))
            return std::nullopt;
        const T dy = step.let(16, "dy", y2 - y1);
        if (!slab(y1, dy, w.min.y, w.max.y, part, 1, step))
            return std::nullopt;
        if (step.test(18, part.stop < T(1), part.stopEdge)) {
            x2 = x1 + part.stop * dx, y2 = y1 + part.stop * dy;
            step.cut(19, 1, x2, y2, part.stopEdge);
        }
        if (step.test(20, part.start > T(0), part.startEdge)) {
            x1 = x1 + part.start * dx, y1 = y1 + part.start * dy;
            step.cut(21, 0, x1, y1, part.startEdge);
        }
        return step.accept(22, BasicSegment<T>{{x1, y1}, {x2, y2}});
    }

    static constexpr std::string_view correctedCode = R"(
slab(p, d, low, high):
  if d == 0
    if p < low or p > high: reject
  else
    t1 = (low-p)/d,  t2 = (high-p)/d
    if t1 > t2
      t = t1,  t1 = t2,  t2 = t
    if t1 > near
      near = t1
    if t2 < far
      far = t2
    if near > far: reject
near = 0,  far = 1
dx = x2-x1
slab(x1, dx, xmin, xmax)
dy = y2-y1
slab(y1, dy, ymin, ymax)
if far < 1
  x2 = held(x1 + far*dx),  y2 = held(y1 + far*dy)
else
  x2 = held(x2),  y2 = held(y2)
if near > 0
  x1 = held(x1 + near*dx),  y1 = held(y1 + near*dy)
  if far < 1 and near == far
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
        step.set("near", part.start), step.let(13, "far", part.stop);
        glm::vec<N, T> d;
        for (glm::length_t k = 0; k < N; ++k) {
            d[k] = step.let(lineOn(k, 14 + 2 * k), extentNames[std::size_t(k)], s.b[k] - s.a[k]);
            if (!slab(s.a[k], d[k], w.min[k], w.max[k], part, k, step))
                return std::nullopt;
        }
        return step.accept(28, endsOf(part, s, d, w, 18, step));
    }
};

template Algorithm describe<KayKajiya>();

} // namespace clipping
