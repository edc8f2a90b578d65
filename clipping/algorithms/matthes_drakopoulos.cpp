// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos (2019), the method this project grew from.
//
//   D. Matthes, V. Drakopoulos: Another Simple but Faster Method for 2D Line Clipping.
//   International Journal of Computer Graphics & Animation 9(1/2/3), 2019, 1-15.
//
// Published: the paper's pseudo-code (its prose has two misprints). Corrected: each move starts
// from the given end; whether the end is then beyond the bottom or top is decided by its rise,
// which is accurate, not by its rounded y; new ends are clamped to the window.

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/box/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

struct MatthesDrakopoulos {
    static constexpr About about{
        .key = "matthes-drakopoulos",
        .abbreviation = "MD",
        .name = "Matthes-Drakopoulos",
        .year = 2019,
        .idea = "Move both ends to the edges that they lie beyond; if both are then still beyond "
                "one edge, the segment misses the window.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr auto box = &matthesDrakopoulosBox;
    static constexpr auto line = &matthesDrakopoulosLine;
    static constexpr auto ray = &matthesDrakopoulosRay;

    static constexpr std::string_view publishedCode = R"(
if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)
  reject
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)
  reject
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
for i = 1, 2
  if x[i] < xmin
    rise = (y2-y1)/(x2-x1) * (xmin-x1)
    x[i] = xmin,  y[i] = rise + y1
  else if x[i] > xmax
    rise = (y2-y1)/(x2-x1) * (xmax-x1)
    x[i] = xmax,  y[i] = rise + y1
  if y[i] < ymin
    run = (x2-x1)/(y2-y1) * (ymin-y1)
    y[i] = ymin,  x[i] = run + x1
  else if y[i] > ymax
    run = (x2-x1)/(y2-y1) * (ymax-y1)
    y[i] = ymax,  x[i] = run + x1
if (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)
  reject
accept the line from x[1], y[1] to x[2], y[2]
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test(1, (x1 < xmin && x2 < xmin) || (x1 > xmax && x2 > xmax), Edge::Left,
                      Edge::Right))
            return step.reject(2);
        if (step.test(3, (y1 < ymin && y2 < ymin) || (y1 > ymax && y2 > ymax), Edge::Bottom,
                      Edge::Top))
            return step.reject(4);
        T x[]{x1, x2}, y[]{y1, y2};
        for (int i = 0; i < 2; ++i) {
            step.set("i", i + 1);
            if (step.test(7, x[i] < xmin, Edge::Left)) {
                const T rise = step.let(8, "rise", (y2 - y1) / (x2 - x1) * (xmin - x1), Edge::Left);
                x[i] = xmin, y[i] = rise + y1;
                step.cut(9, i, x[i], y[i], Edge::Left);
            } else if (step.test(10, x[i] > xmax, Edge::Right)) {
                const T rise =
                    step.let(11, "rise", (y2 - y1) / (x2 - x1) * (xmax - x1), Edge::Right);
                x[i] = xmax, y[i] = rise + y1;
                step.cut(12, i, x[i], y[i], Edge::Right);
            }
            if (step.test(13, y[i] < ymin, Edge::Bottom)) {
                const T run =
                    step.let(14, "run", (x2 - x1) / (y2 - y1) * (ymin - y1), Edge::Bottom);
                y[i] = ymin, x[i] = run + x1;
                step.cut(15, i, x[i], y[i], Edge::Bottom);
            } else if (step.test(16, y[i] > ymax, Edge::Top)) {
                const T run = step.let(17, "run", (x2 - x1) / (y2 - y1) * (ymax - y1), Edge::Top);
                y[i] = ymax, x[i] = run + x1;
                step.cut(18, i, x[i], y[i], Edge::Top);
            }
        }
        if (step.test(19, (x[0] < xmin && x[1] < xmin) || (x[0] > xmax && x[1] > xmax), Edge::Left,
                      Edge::Right))
            return step.reject(20);
        return step.accept(21, BasicSegment<T>{{x[0], y[0]}, {x[1], y[1]}});
    }

    static constexpr std::string_view correctedCode = R"(
if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)
  reject
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)
  reject
dx = x2-x1,  dy = y2-y1
for i = 1, 2
  moved = false,  x[i] = xi,  y[i] = yi
  if xi < xmin
    rise = dy * (xmin-xi) / dx
    x[i] = xmin,  y[i] = rise + yi,  moved = true
  else if xi > xmax
    rise = dy * (xmax-xi) / dx
    x[i] = xmax,  y[i] = rise + yi,  moved = true
  if (moved ? rise < ymin-yi : yi < ymin)
    run = dx * (ymin-yi) / dy
    y[i] = ymin,  x[i] = run + xi
  else if (moved ? rise > ymax-yi : yi > ymax)
    run = dx * (ymax-yi) / dy
    y[i] = ymax,  x[i] = run + xi
if (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)
  reject
hold new ends inside the window
accept the line from x[1], y[1] to x[2], y[2]
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test(1, (x1 < xmin && x2 < xmin) || (x1 > xmax && x2 > xmax), Edge::Left,
                      Edge::Right))
            return step.reject(2);
        if (step.test(3, (y1 < ymin && y2 < ymin) || (y1 > ymax && y2 > ymax), Edge::Bottom,
                      Edge::Top))
            return step.reject(4);
        const T dx = step.set("dx", x2 - x1), dy = step.let(5, "dy", y2 - y1);
        BasicSegment<T> visible = s;
        Edge edges[]{Edge::NoEdge, Edge::NoEdge}; // the edges that cut End 1 and End 2 last
        for (int i = 0; i < 2; ++i) {
            step.set("i", i + 1);
            const T xi = step.set("xi", i == 0 ? x1 : x2), yi = step.set("yi", i == 0 ? y1 : y2);
            glm::vec<2, T>& p = i == 0 ? visible.a : visible.b;
            Edge& edge = edges[i];
            bool moved = step.let(7, "moved", false);
            T rise(0);
            if (step.test(8, xi < xmin, Edge::Left)) {
                rise = step.let(9, "rise", dy * (xmin - xi) / dx, Edge::Left);
                p = {xmin, rise + yi}, edge = Edge::Left, moved = step.set("moved", true);
                step.cut(10, i, p, edge);
            } else if (step.test(11, xi > xmax, Edge::Right)) {
                rise = step.let(12, "rise", dy * (xmax - xi) / dx, Edge::Right);
                p = {xmax, rise + yi}, edge = Edge::Right, moved = step.set("moved", true);
                step.cut(13, i, p, edge);
            }
            if (step.test(14, moved ? rise < ymin - yi : yi < ymin, Edge::Bottom)) {
                const T run = step.let(15, "run", dx * (ymin - yi) / dy, Edge::Bottom);
                p = {run + xi, ymin}, edge = Edge::Bottom;
                step.cut(16, i, p, edge);
            } else if (step.test(17, moved ? rise > ymax - yi : yi > ymax, Edge::Top)) {
                const T run = step.let(18, "run", dx * (ymax - yi) / dy, Edge::Top);
                p = {run + xi, ymax}, edge = Edge::Top;
                step.cut(19, i, p, edge);
            }
        }
        const auto& [a, b] = visible;
        if (step.test(20, (a.x < xmin && b.x < xmin) || (a.x > xmax && b.x > xmax), Edge::Left,
                      Edge::Right))
            return step.reject(21);
        visible = {clampedAlong(edges[0], a, w), clampedAlong(edges[1], b, w)};
        step.left(22, visible);
        return step.accept(23, visible);
    }
};

template Algorithm describe<MatthesDrakopoulos>();

} // namespace clipping
