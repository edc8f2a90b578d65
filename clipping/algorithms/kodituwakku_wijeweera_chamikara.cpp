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
if x[1] != x[2]  #notUpright
  if y[1] != y[2]  #notLevel
    m = (y[1]-y[2])/(x[1]-x[2])  #m
    c = (x[1]*y[2]-x[2]*y[1])/(x[1]-x[2])  #c
    for i = 1, 2
      if x[i] < xmin  #left
        x[i] = xmin,  y[i] = m*xmin + c  #toLeft
      else if x[i] > xmax  #right
        x[i] = xmax,  y[i] = m*xmax + c  #toRight
      if y[i] < ymin  #bottom
        x[i] = (ymin-c)/m,  y[i] = ymin  #toBottom
      else if y[i] > ymax  #top
        x[i] = (ymax-c)/m,  y[i] = ymax  #toTop
    if x[1]-x[2] < 1 and x[2]-x[1] < 1  #short
      reject  #rejectShort
  else
    if y[1] <= ymin or y[1] >= ymax  #levelOutside
      reject  #rejectLevel
    for i = 1, 2
      if x[i] < xmin  #levelLeft
        x[i] = xmin  #levelToLeft
      else if x[i] > xmax  #levelRight
        x[i] = xmax  #levelToRight
    if x[1]-x[2] < 1 and x[2]-x[1] < 1  #levelShort
      reject  #rejectLevelShort
else if y[1] == y[2]  #point
  if y[1] <= ymin or y[1] >= ymax or x[1] <= xmin or x[1] >= xmax  #pointOutside
    reject  #rejectPoint
else
  if x[1] <= xmin or x[1] >= xmax  #uprightOutside
    reject  #rejectUpright
  for i = 1, 2
    if y[i] < ymin  #uprightBottom
      y[i] = ymin  #uprightToBottom
    else if y[i] > ymax  #uprightTop
      y[i] = ymax  #uprightToTop
  if y[1]-y[2] < 1 and y[2]-y[1] < 1  #uprightShort
    reject  #rejectUprightShort
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): one function, as its authors list it
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        T x[]{s.a.x, s.b.x}, y[]{s.a.y, s.b.y};
        if (step.test("notUpright", x[0] != x[1])) {
            if (step.test("notLevel", y[0] != y[1])) {
                const T m = step.let("m", "m", (y[0] - y[1]) / (x[0] - x[1]));
                const T c = step.let("c", "c", (x[0] * y[1] - x[1] * y[0]) / (x[0] - x[1]));
                for (int i = 0; i < 2; ++i) {
                    step.set("i", i + 1);
                    if (step.test("left", x[i] < xmin, Edge::Left)) {
                        x[i] = xmin, y[i] = m * xmin + c;
                        step.cut("toLeft", i, x[i], y[i], Edge::Left);
                    } else if (step.test("right", x[i] > xmax, Edge::Right)) {
                        x[i] = xmax, y[i] = m * xmax + c;
                        step.cut("toRight", i, x[i], y[i], Edge::Right);
                    }
                    if (step.test("bottom", y[i] < ymin, Edge::Bottom)) {
                        x[i] = (ymin - c) / m, y[i] = ymin;
                        step.cut("toBottom", i, x[i], y[i], Edge::Bottom);
                    } else if (step.test("top", y[i] > ymax, Edge::Top)) {
                        x[i] = (ymax - c) / m, y[i] = ymax;
                        step.cut("toTop", i, x[i], y[i], Edge::Top);
                    }
                }
                if (step.test("short", x[0] - x[1] < T(1) && x[1] - x[0] < T(1)))
                    return step.reject("rejectShort");
            } else {
                if (step.test("levelOutside", y[0] <= ymin || y[0] >= ymax))
                    return step.reject("rejectLevel");
                for (int i = 0; i < 2; ++i) {
                    step.set("i", i + 1);
                    if (step.test("levelLeft", x[i] < xmin, Edge::Left)) {
                        x[i] = xmin;
                        step.cut("levelToLeft", i, x[i], y[i], Edge::Left);
                    } else if (step.test("levelRight", x[i] > xmax, Edge::Right)) {
                        x[i] = xmax;
                        step.cut("levelToRight", i, x[i], y[i], Edge::Right);
                    }
                }
                if (step.test("levelShort", x[0] - x[1] < T(1) && x[1] - x[0] < T(1)))
                    return step.reject("rejectLevelShort");
            }
        } else if (step.test("point", y[0] == y[1])) {
            if (step.test("pointOutside",
                          y[0] <= ymin || y[0] >= ymax || x[0] <= xmin || x[0] >= xmax))
                return step.reject("rejectPoint");
        } else {
            if (step.test("uprightOutside", x[0] <= xmin || x[0] >= xmax))
                return step.reject("rejectUpright");
            for (int i = 0; i < 2; ++i) {
                step.set("i", i + 1);
                if (step.test("uprightBottom", y[i] < ymin, Edge::Bottom)) {
                    y[i] = ymin;
                    step.cut("uprightToBottom", i, x[i], y[i], Edge::Bottom);
                } else if (step.test("uprightTop", y[i] > ymax, Edge::Top)) {
                    y[i] = ymax;
                    step.cut("uprightToTop", i, x[i], y[i], Edge::Top);
                }
            }
            if (step.test("uprightShort", y[0] - y[1] < T(1) && y[1] - y[0] < T(1)))
                return step.reject("rejectUprightShort");
        }
        return step.accept("accept", BasicSegment<T>{{x[0], y[0]}, {x[1], y[1]}});
    }

    static constexpr std::string_view correctedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if x1 != x2  #notUpright
  if y1 != y2  #notLevel
    dx = x2-x1,  dy = y2-y1  #extent
    push(1, x1, y1, x2, y2)  #push1
    push(2, x2, y2, x1, y1)  #push2
    hold new ends inside the window  #hold
  else
    if y1 < ymin or y1 > ymax: reject  #levelOutside
    pushInX(1, x1, x2)  #level1
    pushInX(2, x2, x1)  #level2
else if y1 == y2  #point
  if y1 < ymin or y1 > ymax or x1 < xmin or x1 > xmax: reject  #pointOutside
else
  if x1 < xmin or x1 > xmax: reject  #uprightOutside
  pushInY(1, y1, y2)  #upright1
  pushInY(2, y2, y1)  #upright2
accept the line from x[1], y[1] to x[2], y[2]  #accept
push(i, xi, yi, xo, yo):
  moved = false
  if xi < xmin  #left
    if xo < xmin: reject  #bothLeft
    rise = dy * (xmin-xi) / dx  #riseToLeft
    x[i] = xmin,  y[i] = yi + rise,  moved = true  #toLeft
  else if xi > xmax  #right
    if xo > xmax: reject  #bothRight
    rise = dy * (xmax-xi) / dx  #riseToRight
    x[i] = xmax,  y[i] = yi + rise,  moved = true  #toRight
  if (moved ? rise < ymin-yi : yi < ymin)  #bottom
    if yo < ymin: reject  #bothBelow
    run = dx * (ymin-yi) / dy  #runToBottom
    x[i] = xi + run,  y[i] = ymin  #toBottom
  else if (moved ? rise > ymax-yi : yi > ymax)  #top
    if yo > ymax: reject  #bothAbove
    run = dx * (ymax-yi) / dy  #runToTop
    x[i] = xi + run,  y[i] = ymax  #toTop
pushInX(i, xi, xo):
  if xi < xmin  #levelLeft
    if xo < xmin: reject  #levelBothLeft
    x[i] = xmin  #levelToLeft
  else if xi > xmax  #levelRight
    if xo > xmax: reject  #levelBothRight
    x[i] = xmax  #levelToRight
pushInY(i, yi, yo):
  if yi < ymin  #uprightBottom
    if yo < ymin: reject  #uprightBothBelow
    y[i] = ymin  #uprightToBottom
  else if yi > ymax  #uprightTop
    if yo > ymax: reject  #uprightBothAbove
    y[i] = ymax  #uprightToTop
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test("notUpright", x1 != x2)) {
            if (step.test("notLevel", y1 != y2))
                return slanted(s, w, step);
            if (step.test("levelOutside", y1 < ymin || y1 > ymax, Edge::Bottom, Edge::Top))
                return step.reject("levelOutside");
            return straight(0, s, w, step);
        }
        if (step.test("point", y1 == y2)) {
            if (step.test("pointOutside", y1 < ymin || y1 > ymax || x1 < xmin || x1 > xmax))
                return step.reject("pointOutside");
            return step.accept("accept", s);
        }
        if (step.test("uprightOutside", x1 < xmin || x1 > xmax, Edge::Left, Edge::Right))
            return step.reject("uprightOutside");
        return straight(1, s, w, step);
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> slanted(const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, Step& step)
    {
        const T dx = step.set("dx", s.b.x - s.a.x), dy = step.let("extent", "dy", s.b.y - s.a.y);
        BasicSegment<T> visible = s;
        const auto edge1 = push(1, visible.a, s, {dx, dy}, w, step);
        if (!edge1)
            return std::nullopt;
        const auto edge2 = push(2, visible.b, s, {dx, dy}, w, step);
        if (!edge2)
            return std::nullopt;
        visible = {clampedAlong(*edge1, visible.a, w), clampedAlong(*edge2, visible.b, w)};
        step.left("hold", visible);
        return step.accept("accept", visible);
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
        const T xo = step.set("xo", other.x),
                yo = step.let(i == 1 ? "push1" : "push2", "yo", other.y);
        Edge edge = Edge::NoEdge;
        T rise(0);
        if (step.test("left", xi < xmin, Edge::Left)) {
            if (step.test("bothLeft", xo < xmin, Edge::Left))
                return step.reject("bothLeft");
            rise = step.let("riseToLeft", "rise", dy * (xmin - xi) / dx, Edge::Left);
            at = {xmin, yi + rise}, edge = Edge::Left, moved = step.set("moved", true);
            step.cut("toLeft", i - 1, at, edge);
        } else if (step.test("right", xi > xmax, Edge::Right)) {
            if (step.test("bothRight", xo > xmax, Edge::Right))
                return step.reject("bothRight");
            rise = step.let("riseToRight", "rise", dy * (xmax - xi) / dx, Edge::Right);
            at = {xmax, yi + rise}, edge = Edge::Right, moved = step.set("moved", true);
            step.cut("toRight", i - 1, at, edge);
        }
        if (step.test("bottom", moved ? rise < ymin - yi : yi < ymin, Edge::Bottom)) {
            if (step.test("bothBelow", yo < ymin, Edge::Bottom))
                return step.reject("bothBelow");
            const T run = step.let("runToBottom", "run", dx * (ymin - yi) / dy, Edge::Bottom);
            at = {xi + run, ymin}, edge = Edge::Bottom;
            step.cut("toBottom", i - 1, at, edge);
        } else if (step.test("top", moved ? rise > ymax - yi : yi > ymax, Edge::Top)) {
            if (step.test("bothAbove", yo > ymax, Edge::Top))
                return step.reject("bothAbove");
            const T run = step.let("runToTop", "run", dx * (ymax - yi) / dy, Edge::Top);
            at = {xi + run, ymax}, edge = Edge::Top;
            step.cut("toTop", i - 1, at, edge);
        }
        return edge;
    }

    /// Clips a segment parallel to x (axis 0) or y (axis 1) that is within the window's range on
    /// the other axis.
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
        return step.accept("accept", BasicSegment<T>{*end1, *end2});
    }

    /// The labels of pushInX or pushInY, and of its calls for End 1 and End 2.
    struct PushLabels {
        std::array<std::string_view, 2> calls;
        std::string_view below, bothBelow, toLow, above, bothAbove, toHigh;
    };
    static constexpr std::array<PushLabels, 2> pushLabels{{{{"level1", "level2"},
                                                            "levelLeft",
                                                            "levelBothLeft",
                                                            "levelToLeft",
                                                            "levelRight",
                                                            "levelBothRight",
                                                            "levelToRight"},
                                                           {{"upright1", "upright2"},
                                                            "uprightBottom",
                                                            "uprightBothBelow",
                                                            "uprightToBottom",
                                                            "uprightTop",
                                                            "uprightBothAbove",
                                                            "uprightToTop"}}};

    /// pushInX (axis 0) or pushInY (axis 1): returns the new position of End i.
    template <class T, class Step>
    static constexpr std::optional<glm::vec<2, T>>
    pushAlong(int axis, int i, const BasicSegment<T>& s, const BasicWindow<T>& w, Step& step)
    {
        const PushLabels& labels = pushLabels[std::size_t(axis)];
        const Edge lower = lowerEdge(axis), upper = upperEdge(axis);
        const T low = w.min[axis], high = w.max[axis];
        glm::vec<2, T> end = i == 1 ? s.a : s.b;
        step.set("i", i);
        const T vi = step.set(axis == 0 ? "xi" : "yi", end[axis]);
        const T vo = step.let(labels.calls[std::size_t(i - 1)], axis == 0 ? "xo" : "yo",
                              i == 1 ? s.b[axis] : s.a[axis]);
        if (step.test(labels.below, vi < low, lower)) {
            if (step.test(labels.bothBelow, vo < low, lower))
                return step.reject(labels.bothBelow);
            end[axis] = low;
            step.cut(labels.toLow, i - 1, end, lower);
        } else if (step.test(labels.above, vi > high, upper)) {
            if (step.test(labels.bothAbove, vo > high, upper))
                return step.reject(labels.bothAbove);
            end[axis] = high;
            step.cut(labels.toHigh, i - 1, end, upper);
        }
        return end;
    }
};

template Algorithm describe<KodituwakkuWijeweeraChamikara>();

} // namespace clipping
