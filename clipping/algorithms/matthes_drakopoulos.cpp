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
if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
for i = 1, 2
  if x[i] < xmin  #left
    rise = (y2-y1)/(x2-x1) * (xmin-x1)  #riseToLeft
    x[i] = xmin,  y[i] = rise + y1  #toLeft
  else if x[i] > xmax  #right
    rise = (y2-y1)/(x2-x1) * (xmax-x1)  #riseToRight
    x[i] = xmax,  y[i] = rise + y1  #toRight
  if y[i] < ymin  #bottom
    run = (x2-x1)/(y2-y1) * (ymin-y1)  #runToBottom
    y[i] = ymin,  x[i] = run + x1  #toBottom
  else if y[i] > ymax  #top
    run = (x2-x1)/(y2-y1) * (ymax-y1)  #runToTop
    y[i] = ymax,  x[i] = run + x1  #toTop
if (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)  #missed
  reject  #reject
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test("besideX", (x1 < xmin && x2 < xmin) || (x1 > xmax && x2 > xmax), Edge::Left,
                      Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", (y1 < ymin && y2 < ymin) || (y1 > ymax && y2 > ymax), Edge::Bottom,
                      Edge::Top))
            return step.reject("rejectY");
        T x[]{x1, x2}, y[]{y1, y2};
        for (int i = 0; i < 2; ++i) {
            step.set("i", i + 1);
            if (step.test("left", x[i] < xmin, Edge::Left)) {
                const T rise =
                    step.let("riseToLeft", "rise", (y2 - y1) / (x2 - x1) * (xmin - x1), Edge::Left);
                x[i] = xmin, y[i] = rise + y1;
                step.cut("toLeft", i, x[i], y[i], Edge::Left);
            } else if (step.test("right", x[i] > xmax, Edge::Right)) {
                const T rise = step.let("riseToRight", "rise", (y2 - y1) / (x2 - x1) * (xmax - x1),
                                        Edge::Right);
                x[i] = xmax, y[i] = rise + y1;
                step.cut("toRight", i, x[i], y[i], Edge::Right);
            }
            if (step.test("bottom", y[i] < ymin, Edge::Bottom)) {
                const T run = step.let("runToBottom", "run", (x2 - x1) / (y2 - y1) * (ymin - y1),
                                       Edge::Bottom);
                y[i] = ymin, x[i] = run + x1;
                step.cut("toBottom", i, x[i], y[i], Edge::Bottom);
            } else if (step.test("top", y[i] > ymax, Edge::Top)) {
                const T run =
                    step.let("runToTop", "run", (x2 - x1) / (y2 - y1) * (ymax - y1), Edge::Top);
                y[i] = ymax, x[i] = run + x1;
                step.cut("toTop", i, x[i], y[i], Edge::Top);
            }
        }
        if (step.test("missed", (x[0] < xmin && x[1] < xmin) || (x[0] > xmax && x[1] > xmax),
                      Edge::Left, Edge::Right))
            return step.reject("reject");
        return step.accept("accept", BasicSegment<T>{{x[0], y[0]}, {x[1], y[1]}});
    }

    static constexpr std::string_view correctedCode = R"(
if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
  reject  #rejectX
if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
  reject  #rejectY
dx = x2-x1,  dy = y2-y1  #extent
for i = 1, 2
  moved = false,  x[i] = xi,  y[i] = yi  #moved
  if xi < xmin  #left
    rise = dy * (xmin-xi) / dx  #riseToLeft
    x[i] = xmin,  y[i] = rise + yi,  moved = true  #toLeft
  else if xi > xmax  #right
    rise = dy * (xmax-xi) / dx  #riseToRight
    x[i] = xmax,  y[i] = rise + yi,  moved = true  #toRight
  if (moved ? rise < ymin-yi : yi < ymin)  #bottom
    run = dx * (ymin-yi) / dy  #runToBottom
    y[i] = ymin,  x[i] = run + xi  #toBottom
  else if (moved ? rise > ymax-yi : yi > ymax)  #top
    run = dx * (ymax-yi) / dy  #runToTop
    y[i] = ymax,  x[i] = run + xi  #toTop
if (x[1] < xmin and x[2] < xmin) or (x[1] > xmax and x[2] > xmax)  #missed
  reject  #reject
hold new ends inside the window  #hold
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test("besideX", (x1 < xmin && x2 < xmin) || (x1 > xmax && x2 > xmax), Edge::Left,
                      Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", (y1 < ymin && y2 < ymin) || (y1 > ymax && y2 > ymax), Edge::Bottom,
                      Edge::Top))
            return step.reject("rejectY");
        const T dx = step.set("dx", x2 - x1), dy = step.let("extent", "dy", y2 - y1);
        BasicSegment<T> visible = s;
        Edge edges[]{Edge::NoEdge, Edge::NoEdge}; // the edges that cut End 1 and End 2 last
        for (int i = 0; i < 2; ++i) {
            step.set("i", i + 1);
            const T xi = step.set("xi", i == 0 ? x1 : x2), yi = step.set("yi", i == 0 ? y1 : y2);
            glm::vec<2, T>& p = i == 0 ? visible.a : visible.b;
            Edge& edge = edges[i];
            bool moved = step.let("moved", "moved", false);
            T rise(0);
            if (step.test("left", xi < xmin, Edge::Left)) {
                rise = step.let("riseToLeft", "rise", dy * (xmin - xi) / dx, Edge::Left);
                p = {xmin, rise + yi}, edge = Edge::Left, moved = step.set("moved", true);
                step.cut("toLeft", i, p, edge);
            } else if (step.test("right", xi > xmax, Edge::Right)) {
                rise = step.let("riseToRight", "rise", dy * (xmax - xi) / dx, Edge::Right);
                p = {xmax, rise + yi}, edge = Edge::Right, moved = step.set("moved", true);
                step.cut("toRight", i, p, edge);
            }
            if (step.test("bottom", moved ? rise < ymin - yi : yi < ymin, Edge::Bottom)) {
                const T run = step.let("runToBottom", "run", dx * (ymin - yi) / dy, Edge::Bottom);
                p = {run + xi, ymin}, edge = Edge::Bottom;
                step.cut("toBottom", i, p, edge);
            } else if (step.test("top", moved ? rise > ymax - yi : yi > ymax, Edge::Top)) {
                const T run = step.let("runToTop", "run", dx * (ymax - yi) / dy, Edge::Top);
                p = {run + xi, ymax}, edge = Edge::Top;
                step.cut("toTop", i, p, edge);
            }
        }
        const auto& [a, b] = visible;
        if (step.test("missed", (a.x < xmin && b.x < xmin) || (a.x > xmax && b.x > xmax),
                      Edge::Left, Edge::Right))
            return step.reject("reject");
        visible = {clampedAlong(edges[0], a, w), clampedAlong(edges[1], b, w)};
        step.left("hold", visible);
        return step.accept("accept", visible);
    }
};

template Algorithm describe<MatthesDrakopoulos>();

} // namespace clipping
