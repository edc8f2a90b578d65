// SPDX-License-Identifier: MIT
//
// Kodituwakku-Wijeweera-Chamikara (2013).
//
//   S. R. Kodituwakku, K. R. Wijeweera, M. A. P. Chamikara: An Efficient Algorithm for Line
//   Clipping in Computer Graphics Programming. Ceylon Journal of Science (Physical Sciences) 17,
//   2013, 1-7.
//
// Published: the listing of the paper's appendix. It treats a result shorter than one pixel as a
// miss, and so loses short pieces, steep ones, contacts, and everything on an edge. Corrected:
// every comparison is closed. A segment is rejected by position: if both ends are beyond one edge,
// it misses the window, and every miss shows this at one of the moved ends. The slope stays a
// fraction, each move starts from the given end, and new ends are clamped to the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

struct KodituwakkuWijeweeraChamikara {
    static constexpr About about{
        .key = "kodituwakku-wijeweera-chamikara",
        .abbreviation = "KWC",
        .name = "Kodituwakku-Wijeweera-Chamikara",
        .year = 2013,
        .idea = "Move both ends to the window's edges with y = mx + c, and reject a segment that "
                "has shrunk to a point.",
        .ulps = 24, // README.md, "How far off"
    };

    static constexpr std::string_view publishedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if x[1] != x[2]
  if y[1] != y[2]
    m = (y[1]-y[2])/(x[1]-x[2])
    c = (x[1]*y[2]-x[2]*y[1])/(x[1]-x[2])
    for i = 1, 2
      if x[i] < xmin
        x[i] = xmin,  y[i] = m*xmin + c
      else if x[i] > xmax
        x[i] = xmax,  y[i] = m*xmax + c
      if y[i] < ymin
        x[i] = (ymin-c)/m,  y[i] = ymin
      else if y[i] > ymax
        x[i] = (ymax-c)/m,  y[i] = ymax
    if x[1]-x[2] < 1 and x[2]-x[1] < 1
      reject
  else
    if y[1] <= ymin or y[1] >= ymax
      reject
    for i = 1, 2
      if x[i] < xmin
        x[i] = xmin
      else if x[i] > xmax
        x[i] = xmax
    if x[1]-x[2] < 1 and x[2]-x[1] < 1
      reject
else if y[1] == y[2]
  if y[1] <= ymin or y[1] >= ymax or x[1] <= xmin or x[1] >= xmax
    reject
else
  if x[1] <= xmin or x[1] >= xmax
    reject
  for i = 1, 2
    if y[i] < ymin
      y[i] = ymin
    else if y[i] > ymax
      y[i] = ymax
  if y[1]-y[2] < 1 and y[2]-y[1] < 1
    reject
accept the line from x[1], y[1] to x[2], y[2]
)";
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): one function, as its authors list it
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        T x[]{s.a.x, s.b.x}, y[]{s.a.y, s.b.y};
        if (step.test(2, x[0] != x[1])) {
            if (step.test(3, y[0] != y[1])) {
                const T m = step.let(4, "m", (y[0] - y[1]) / (x[0] - x[1]));
                const T c = step.let(5, "c", (x[0] * y[1] - x[1] * y[0]) / (x[0] - x[1]));
                for (int i = 0; i < 2; ++i) {
                    step.set("i", i + 1);
                    if (step.test(7, x[i] < xmin, Edge::Left)) {
                        x[i] = xmin, y[i] = m * xmin + c;
                        step.cut(8, i, x[i], y[i], Edge::Left);
                    } else if (step.test(9, x[i] > xmax, Edge::Right)) {
                        x[i] = xmax, y[i] = m * xmax + c;
                        step.cut(10, i, x[i], y[i], Edge::Right);
                    }
                    if (step.test(11, y[i] < ymin, Edge::Bottom)) {
                        x[i] = (ymin - c) / m, y[i] = ymin;
                        step.cut(12, i, x[i], y[i], Edge::Bottom);
                    } else if (step.test(13, y[i] > ymax, Edge::Top)) {
                        x[i] = (ymax - c) / m, y[i] = ymax;
                        step.cut(14, i, x[i], y[i], Edge::Top);
                    }
                }
                if (step.test(15, x[0] - x[1] < T(1) && x[1] - x[0] < T(1)))
                    return step.reject(16);
            } else {
                if (step.test(18, y[0] <= ymin || y[0] >= ymax))
                    return step.reject(19);
                for (int i = 0; i < 2; ++i) {
                    step.set("i", i + 1);
                    if (step.test(21, x[i] < xmin, Edge::Left)) {
                        x[i] = xmin;
                        step.cut(22, i, x[i], y[i], Edge::Left);
                    } else if (step.test(23, x[i] > xmax, Edge::Right)) {
                        x[i] = xmax;
                        step.cut(24, i, x[i], y[i], Edge::Right);
                    }
                }
                if (step.test(25, x[0] - x[1] < T(1) && x[1] - x[0] < T(1)))
                    return step.reject(26);
            }
        } else if (step.test(27, y[0] == y[1])) {
            if (step.test(28, y[0] <= ymin || y[0] >= ymax || x[0] <= xmin || x[0] >= xmax))
                return step.reject(29);
        } else {
            if (step.test(31, x[0] <= xmin || x[0] >= xmax))
                return step.reject(32);
            for (int i = 0; i < 2; ++i) {
                step.set("i", i + 1);
                if (step.test(34, y[i] < ymin, Edge::Bottom)) {
                    y[i] = ymin;
                    step.cut(35, i, x[i], y[i], Edge::Bottom);
                } else if (step.test(36, y[i] > ymax, Edge::Top)) {
                    y[i] = ymax;
                    step.cut(37, i, x[i], y[i], Edge::Top);
                }
            }
            if (step.test(38, y[0] - y[1] < T(1) && y[1] - y[0] < T(1)))
                return step.reject(39);
        }
        return step.accept(40, BasicSegment<T>{{x[0], y[0]}, {x[1], y[1]}});
    }

    static constexpr std::string_view correctedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if x1 != x2
  if y1 != y2
    dx = x2-x1,  dy = y2-y1
    push(1, x1, y1, x2, y2)
    push(2, x2, y2, x1, y1)
    hold new ends inside the window
  else
    if y1 < ymin or y1 > ymax: reject
    pushInX(1, x1, x2)
    pushInX(2, x2, x1)
else if y1 == y2
  if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject
else
  if x1 < xmin or x1 > xmax: reject
  pushInY(1, y1, y2)
  pushInY(2, y2, y1)
accept the line from x[1], y[1] to x[2], y[2]
push(i, xi, yi, xo, yo):
  moved = false
  if xi < xmin
    if xo < xmin: reject
    rise = dy * (xmin-xi) / dx
    x[i] = xmin,  y[i] = yi + rise,  moved = true
  else if xi > xmax
    if xo > xmax: reject
    rise = dy * (xmax-xi) / dx
    x[i] = xmax,  y[i] = yi + rise,  moved = true
  if (moved ? rise < ymin-yi : yi < ymin)
    if yo < ymin: reject
    run = dx * (ymin-yi) / dy
    x[i] = xi + run,  y[i] = ymin
  else if (moved ? rise > ymax-yi : yi > ymax)
    if yo > ymax: reject
    run = dx * (ymax-yi) / dy
    x[i] = xi + run,  y[i] = ymax
pushInX(i, xi, xo):
  if xi < xmin
    if xo < xmin: reject
    x[i] = xmin
  else if xi > xmax
    if xo > xmax: reject
    x[i] = xmax
pushInY(i, yi, yo):
  if yi < ymin
    if yo < ymin: reject
    y[i] = ymin
  else if yi > ymax
    if yo > ymax: reject
    y[i] = ymax
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test(2, x1 != x2)) {
            if (step.test(3, y1 != y2))
                return slanted(s, w, step);
            if (step.test(9, y1 < ymin || y1 > ymax, Edge::Bottom, Edge::Top))
                return step.reject(9);
            return straight(0, s, w, step);
        }
        if (step.test(12, y1 == y2)) {
            if (step.test(13, y1 < ymin || y1 > ymax || x1 < xmin || x1 > xmax))
                return step.reject(13);
            return step.accept(18, s);
        }
        if (step.test(15, x1 < xmin || x1 > xmax, Edge::Left, Edge::Right))
            return step.reject(15);
        return straight(1, s, w, step);
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> slanted(const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, Step& step)
    {
        const T dx = step.set("dx", s.b.x - s.a.x), dy = step.let(4, "dy", s.b.y - s.a.y);
        BasicSegment<T> visible = s;
        const auto edge1 = push(1, visible.a, s, {dx, dy}, w, step);
        if (!edge1)
            return std::nullopt;
        const auto edge2 = push(2, visible.b, s, {dx, dy}, w, step);
        if (!edge2)
            return std::nullopt;
        visible = {clampedAlong(*edge1, visible.a, w), clampedAlong(*edge2, visible.b, w)};
        step.left(7, visible);
        return step.accept(18, visible);
    }

    /// Moves End i from `at` to the edges that it is beyond. Returns the last of them, or nothing
    /// if the other end is beyond one of them too.
    template <class T, class Step>
    static constexpr std::optional<Edge> push(int i, glm::vec<2, T>& at, const BasicSegment<T>& s,
                                              const glm::vec<2, T>& d, const BasicWindow<T>& w,
                                              Step& step)
    {
        const T dx = d.x, dy = d.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        const auto &end = i == 1 ? s.a : s.b, &other = i == 1 ? s.b : s.a;
        step.set("i", i);
        bool moved = step.set("moved", false);
        const T xi = step.set("xi", end.x), yi = step.set("yi", end.y);
        const T xo = step.set("xo", other.x), yo = step.let(4 + i, "yo", other.y);
        Edge edge = Edge::NoEdge;
        T rise(0);
        if (step.test(21, xi < xmin, Edge::Left)) {
            if (step.test(22, xo < xmin, Edge::Left))
                return step.reject(22);
            rise = step.let(23, "rise", dy * (xmin - xi) / dx, Edge::Left);
            at = {xmin, yi + rise}, edge = Edge::Left, moved = step.set("moved", true);
            step.cut(24, i - 1, at, edge);
        } else if (step.test(25, xi > xmax, Edge::Right)) {
            if (step.test(26, xo > xmax, Edge::Right))
                return step.reject(26);
            rise = step.let(27, "rise", dy * (xmax - xi) / dx, Edge::Right);
            at = {xmax, yi + rise}, edge = Edge::Right, moved = step.set("moved", true);
            step.cut(28, i - 1, at, edge);
        }
        if (step.test(29, moved ? rise < ymin - yi : yi < ymin, Edge::Bottom)) {
            if (step.test(30, yo < ymin, Edge::Bottom))
                return step.reject(30);
            const T run = step.let(31, "run", dx * (ymin - yi) / dy, Edge::Bottom);
            at = {xi + run, ymin}, edge = Edge::Bottom;
            step.cut(32, i - 1, at, edge);
        } else if (step.test(33, moved ? rise > ymax - yi : yi > ymax, Edge::Top)) {
            if (step.test(34, yo > ymax, Edge::Top))
                return step.reject(34);
            const T run = step.let(35, "run", dx * (ymax - yi) / dy, Edge::Top);
            at = {xi + run, ymax}, edge = Edge::Top;
            step.cut(36, i - 1, at, edge);
        }
        return edge;
    }

    /// Clips a segment parallel to x (axis 0: lines 10 and 11) or y (axis 1: lines 16 and 17) that
    /// is within the window's range on the other axis.
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> straight(int axis, const BasicSegment<T>& s,
                                                             const BasicWindow<T>& w, Step& step)
    {
        const auto end1 = pushAlong(axis, 1, s, w, step);
        if (!end1)
            return std::nullopt;
        const auto end2 = pushAlong(axis, 2, s, w, step);
        if (!end2)
            return std::nullopt;
        return step.accept(18, BasicSegment<T>{*end1, *end2});
    }

    /// pushInX (axis 0) or pushInY (axis 1): returns the new position of End i.
    template <class T, class Step>
    static constexpr std::optional<glm::vec<2, T>>
    pushAlong(int axis, int i, const BasicSegment<T>& s, const BasicWindow<T>& w, Step& step)
    {
        const int call = (axis == 0 ? 9 : 15) + i, line = axis == 0 ? 38 : 45;
        const Edge lower = lowerEdge(axis), upper = upperEdge(axis);
        const T low = w.min[axis], high = w.max[axis];
        glm::vec<2, T> end = i == 1 ? s.a : s.b;
        step.set("i", i);
        const T vi = step.set(axis == 0 ? "xi" : "yi", end[axis]);
        const T vo = step.let(call, axis == 0 ? "xo" : "yo", i == 1 ? s.b[axis] : s.a[axis]);
        if (step.test(line, vi < low, lower)) {
            if (step.test(line + 1, vo < low, lower))
                return step.reject(line + 1);
            end[axis] = low;
            step.cut(line + 2, i - 1, end, lower);
        } else if (step.test(line + 3, vi > high, upper)) {
            if (step.test(line + 4, vo > high, upper))
                return step.reject(line + 4);
            end[axis] = high;
            step.cut(line + 5, i - 1, end, upper);
        }
        return end;
    }
};

template Algorithm describe<KodituwakkuWijeweeraChamikara>();

} // namespace clipping
