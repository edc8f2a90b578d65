// SPDX-License-Identifier: MIT
//
// Nicholl-Lee-Nicholl (1987).
//
//   T. M. Nicholl, D. T. Lee, R. A. Nicholl: An Efficient New Algorithm for 2-D Line Clipping: Its
//   Development and Analysis. Computer Graphics 21(4) (SIGGRAPH '87), 253-262.
//
// Published: the paper's procedures, which are written for an End 1 inside the window, beyond its
// left edge, or beyond its top left corner; for the other regions the plane is rotated or mirrored.
// Corrected: the coordinate of a new end that is not its edge's own is clamped to the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/symmetry.h"

namespace clipping {

struct NichollLeeNicholl {
    static constexpr About about{
        .key = "nicholl-lee-nicholl",
        .abbreviation = "NLN",
        .name = "Nicholl-Lee-Nicholl",
        .year = 1987,
        .idea = "Find the region of the first end, and compare the slope with those to the "
                "window's corners, so that only the intersections that are returned are computed.",
        .ulps = 24, // README.md, "How far off"
    };

    /// The parameters of a procedure, which it may change: the window, the ends, and whether
    /// anything is visible.
    template <class T>
    struct Parameters {
        T xmin, ymax, xmax, ymin, x1, y1, x2, y2;
        bool display;
    };

    /// The parameters of a procedure that runs in the plane transformed by Symmetry.
    template <class Symmetry, class T, class Step>
    struct Turned {
        int line; ///< of the call
        Parameters<T>& outside;
        Step& outsideStep;
        Parameters<T> inside;
        decltype(turnedStep<typename Symmetry::Inverse>(std::declval<Step&>())) step;

        /// Transforms the procedure's results back.
        constexpr void back()
        {
            using Back = typename Symmetry::Inverse;
            using V = glm::vec<2, T>;
            const V a = Back::of(V(inside.x1, inside.y1)), b = Back::of(V(inside.x2, inside.y2));
            outside.x1 = a.x, outside.y1 = a.y, outside.x2 = b.x, outside.y2 = b.y;
            outside.display = inside.display;
            tell(outside, outsideStep), outsideStep.set("ymin", outside.ymin);
            outsideStep.left(line, BasicSegment<T>{a, b});
        }
    };

    /// Transforms window and ends for a call.
    template <class Symmetry, class T, class Step>
    static constexpr Turned<Symmetry, T, Step> turned(int line, Parameters<T>& p, Step& step)
    {
        using V = glm::vec<2, T>;
        const auto w = Symmetry::window(BasicWindow<T>{{p.xmin, p.ymin}, {p.xmax, p.ymax}});
        const V a = Symmetry::of(V(p.x1, p.y1)), b = Symmetry::of(V(p.x2, p.y2));
        const Parameters<T> inside{w.min.x, w.max.y, w.max.x, w.min.y,  a.x,
                                   a.y,     b.x,     b.y,     p.display};
        tell(inside, step);
        step.let(line, "ymin", inside.ymin);
        return {line, p, step, inside, turnedStep<typename Symmetry::Inverse>(step)};
    }

    /// Reports the parameters of a procedure, except ymin.
    template <class T>
    static constexpr void tell(const Parameters<T>& p, auto& step)
    {
        step.set("xmin", p.xmin), step.set("ymax", p.ymax), step.set("xmax", p.xmax);
        step.set("x1", p.x1), step.set("y1", p.y1), step.set("x2", p.x2), step.set("y2", p.y2);
    }

    static constexpr std::string_view publishedCode = R"(
display = true
if x1 < xmin: leftColumn(xmin, ymax, xmax, ymin)
else if x1 > xmax: turn leftColumn(-xmax, -ymin, -xmin, -ymax)
else: centreColumn(xmin, ymax, xmax, ymin)
if not display: reject
accept the line from x1, y1 to x2, y2
leftColumn(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false
  else if y1 > ymax: topLeftCorner(xmin, ymax, xmax, ymin)
  else if y1 < ymin: mirror topLeftCorner(xmin, -ymin, xmax, -ymax)
  else: leftEdge(xmin, ymax, xmax, ymin)
topLeftCorner(xmin, ymax, xmax, ymin):
  if y2 > ymax: display = false,  return
  dx = x2-x1,  dy = y2-y1
  pymax = (ymax-y1) * dx,  pxmin = (xmin-x1) * dy
  if pymax > pxmin
    leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin)
  else
    mirror leftBottomRegion(-ymax, -xmin, -ymin, -xmax, -dy, -dx, pymax)
leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin):
  if y2 >= ymin
    if x2 > xmax: y2 = y1 + (xmax-x1) * dy / dx,  x2 = xmax
  else
    pymin = (ymin-y1) * dx
    if pymin > pxmin: display = false,  return
    if x2 > xmax
      pxmax = (xmax-x1) * dy
      if pymin > pxmax: x2 = x1 + pymin / dy,  y2 = ymin
      else: y2 = y1 + pxmax / dx,  x2 = xmax
    else: x2 = x1 + pymin / dy,  y2 = ymin
  y1 = y1 + pxmin / dx,  x1 = xmin
leftEdge(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false
  else if y2 < ymin: p2Bottom(xmin, ymax, xmax, ymin)
  else if y2 > ymax: mirror p2Bottom(xmin, -ymin, xmax, -ymax)
  else
    dx = x2-x1,  dy = y2-y1
    if x2 > xmax: y2 = y1 + dy * (xmax-x1) / dx,  x2 = xmax
    y1 = y1 + dy * (xmin-x1) / dx,  x1 = xmin
p2Bottom(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1
  pxmin = (xmin-x1) * dy,  pymin = (ymin-y1) * dx
  if pymin > pxmin: display = false,  return
  if x2 > xmax
    pxmax = (xmax-x1) * dy
    if pymin > pxmax: x2 = x1 + pymin / dy,  y2 = ymin
    else: y2 = y1 + pxmax / dx,  x2 = xmax
  else: x2 = x1 + pymin / dy,  y2 = ymin
  y1 = y1 + pxmin / dx,  x1 = xmin
centreColumn(xmin, ymax, xmax, ymin):
  if y1 > ymax: turn leftEdge(-ymax, xmax, -ymin, xmin)
  else if y1 < ymin: turn leftEdge(ymin, -xmin, ymax, -xmax)
  else: inside(xmin, ymax, xmax, ymin)
inside(xmin, ymax, xmax, ymin):
  if x2 < xmin: p2Left(xmin, ymax, xmax, ymin)
  else if x2 > xmax: turn p2Left(-xmax, -ymin, -xmin, -ymax)
  else if y2 > ymax
    x2 = x1 + (x2-x1) * (ymax-y1) / (y2-y1),  y2 = ymax
  else if y2 < ymin
    x2 = x1 + (x2-x1) * (ymin-y1) / (y2-y1),  y2 = ymin
p2Left(xmin, ymax, xmax, ymin):
  if y2 > ymax: p2LeftTop(xmin, ymax, xmax, ymin)
  else if y2 < ymin: turn p2LeftTop(ymin, -xmin, ymax, -xmax)
  else: y2 = y1 + (y2-y1) * (xmin-x1) / (x2-x1),  x2 = xmin
p2LeftTop(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1
  pxmin = dy * (xmin-x1),  pymax = dx * (ymax-y1)
  if pymax > pxmin: x2 = x1 + pymax / dy,  y2 = ymax
  else: y2 = y1 + pxmin / dx,  x2 = xmin
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        Parameters<T> p{w.min.x, w.max.y, w.max.x, w.min.y, s.a.x, s.a.y, s.b.x, s.b.y, true};
        auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
        step.set("display", display);
        if (step.test(2, x1 < xmin, Edge::Left))
            Published::leftColumn(p, step);
        else if (step.test(3, x1 > xmax, Edge::Right)) {
            auto half = turned<HalfTurn>(3, p, step);
            Published::leftColumn(half.inside, half.step);
            half.back();
        } else
            Published::centreColumn(p, step);
        if (step.test(5, !display))
            return step.reject(5);
        return step.accept(6, BasicSegment<T>{{x1, y1}, {x2, y2}});
    }
    /// The procedures, in the order of the pseudo-code.
    struct Published {
        /// End 1 is left of the window.
        static constexpr void leftColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(8, x2 < xmin, Edge::Left))
                display = step.let(8, "display", false, Edge::Left);
            else if (step.test(9, y1 > ymax, Edge::Top))
                topLeftCorner(p, step);
            else if (step.test(10, y1 < ymin, Edge::Bottom)) {
                auto mirrored = turned<MirrorInX>(10, p, step);
                topLeftCorner(mirrored.inside, mirrored.step);
                mirrored.back();
            } else
                leftEdge(p, step);
        }

        /// End 1 is left of the window and above it.
        static constexpr void topLeftCorner(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(13, y2 > ymax, Edge::Top))
                return void(display = step.let(13, "display", false, Edge::Top));
            const auto dx = step.set("dx", x2 - x1), dy = step.let(14, "dy", y2 - y1);
            const auto pymax = step.set("pymax", (ymax - y1) * dx);
            const auto pxmin = step.let(15, "pxmin", (xmin - x1) * dy, Edge::Left);
            if (step.test(16, pymax > pxmin, Edge::Left))
                leftBottomRegion(p, dx, dy, pxmin, step);
            else {
                const auto right = step.set("dx", -dy), up = step.set("dy", -dx);
                step.set("pxmin", pymax);
                auto mirrored = turned<MirrorInDiagonal>(19, p, step);
                leftBottomRegion(mirrored.inside, right, up, pymax, mirrored.step);
                mirrored.back();
            }
        }

        /// End 1 is beyond the top left corner, and the line passes below that corner.
        template <class T>
        // NOLINTNEXTLINE(readability-function-size): nested as in the pseudo-code
        static constexpr void leftBottomRegion(Parameters<T>& p, T dx, T dy, T pxmin, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(21, y2 >= ymin, Edge::Bottom)) {
                if (step.test(22, x2 > xmax, Edge::Right)) {
                    y2 = y1 + (xmax - x1) * dy / dx, x2 = xmax;
                    step.cut(22, 1, x2, y2, Edge::Right);
                }
            } else {
                const T pymin = step.let(24, "pymin", (ymin - y1) * dx, Edge::Bottom);
                if (step.test(25, pymin > pxmin, Edge::Left))
                    return void(display = step.let(25, "display", false, Edge::Bottom));
                if (step.test(26, x2 > xmax, Edge::Right)) {
                    const T pxmax = step.let(27, "pxmax", (xmax - x1) * dy, Edge::Right);
                    if (step.test(28, pymin > pxmax, Edge::Bottom)) {
                        x2 = x1 + pymin / dy, y2 = ymin;
                        step.cut(28, 1, x2, y2, Edge::Bottom);
                    } else {
                        y2 = y1 + pxmax / dx, x2 = xmax;
                        step.cut(29, 1, x2, y2, Edge::Right);
                    }
                } else {
                    x2 = x1 + pymin / dy, y2 = ymin;
                    step.cut(30, 1, x2, y2, Edge::Bottom);
                }
            }
            y1 = y1 + pxmin / dx, x1 = xmin;
            step.cut(31, 0, x1, y1, Edge::Left);
        }

        /// End 1 is left of the window, neither above nor below it.
        static constexpr void leftEdge(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(33, x2 < xmin, Edge::Left))
                display = step.let(33, "display", false, Edge::Left);
            else if (step.test(34, y2 < ymin, Edge::Bottom))
                p2Bottom(p, step);
            else if (step.test(35, y2 > ymax, Edge::Top)) {
                auto mirrored = turned<MirrorInX>(35, p, step);
                p2Bottom(mirrored.inside, mirrored.step);
                mirrored.back();
            } else {
                const auto dx = step.set("dx", x2 - x1), dy = step.let(37, "dy", y2 - y1);
                if (step.test(38, x2 > xmax, Edge::Right)) {
                    y2 = y1 + dy * (xmax - x1) / dx, x2 = xmax;
                    step.cut(38, 1, x2, y2, Edge::Right);
                }
                y1 = y1 + dy * (xmin - x1) / dx, x1 = xmin;
                step.cut(39, 0, x1, y1, Edge::Left);
            }
        }

        /// The same, and End 2 is below the window.
        static constexpr void p2Bottom(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let(41, "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", (xmin - x1) * dy);
            const auto pymin = step.let(42, "pymin", (ymin - y1) * dx, Edge::Bottom);
            if (step.test(43, pymin > pxmin, Edge::Left))
                return void(display = step.let(43, "display", false, Edge::Bottom));
            if (step.test(44, x2 > xmax, Edge::Right)) {
                const auto pxmax = step.let(45, "pxmax", (xmax - x1) * dy, Edge::Right);
                if (step.test(46, pymin > pxmax, Edge::Bottom)) {
                    x2 = x1 + pymin / dy, y2 = ymin;
                    step.cut(46, 1, x2, y2, Edge::Bottom);
                } else {
                    y2 = y1 + pxmax / dx, x2 = xmax;
                    step.cut(47, 1, x2, y2, Edge::Right);
                }
            } else {
                x2 = x1 + pymin / dy, y2 = ymin;
                step.cut(48, 1, x2, y2, Edge::Bottom);
            }
            y1 = y1 + pxmin / dx, x1 = xmin;
            step.cut(49, 0, x1, y1, Edge::Left);
        }

        /// End 1 is neither left nor right of the window.
        static constexpr void centreColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(51, y1 > ymax, Edge::Top)) {
                auto left = turned<ThreeQuarterTurn>(51, p, step);
                leftEdge(left.inside, left.step);
                left.back();
            } else if (step.test(52, y1 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>(52, p, step);
                leftEdge(right.inside, right.step);
                right.back();
            } else
                inside(p, step);
        }

        /// End 1 is inside the window.
        static constexpr void inside(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(55, x2 < xmin, Edge::Left))
                p2Left(p, step);
            else if (step.test(56, x2 > xmax, Edge::Right)) {
                auto half = turned<HalfTurn>(56, p, step);
                p2Left(half.inside, half.step);
                half.back();
            } else if (step.test(57, y2 > ymax, Edge::Top)) {
                x2 = x1 + (x2 - x1) * (ymax - y1) / (y2 - y1), y2 = ymax;
                step.cut(58, 1, x2, y2, Edge::Top);
            } else if (step.test(59, y2 < ymin, Edge::Bottom)) {
                x2 = x1 + (x2 - x1) * (ymin - y1) / (y2 - y1), y2 = ymin;
                step.cut(60, 1, x2, y2, Edge::Bottom);
            }
        }

        /// End 1 is inside the window, End 2 left of it.
        static constexpr void p2Left(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(62, y2 > ymax, Edge::Top))
                p2LeftTop(p, step);
            else if (step.test(63, y2 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>(63, p, step);
                p2LeftTop(right.inside, right.step);
                right.back();
            } else {
                y2 = y1 + (y2 - y1) * (xmin - x1) / (x2 - x1), x2 = xmin;
                step.cut(64, 1, x2, y2, Edge::Left);
            }
        }

        /// End 1 is inside the window, End 2 left of it and above it.
        static constexpr void p2LeftTop(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let(66, "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", dy * (xmin - x1));
            const auto pymax = step.let(67, "pymax", dx * (ymax - y1), Edge::Top);
            if (step.test(68, pymax > pxmin, Edge::Top)) {
                x2 = x1 + pymax / dy, y2 = ymax;
                step.cut(68, 1, x2, y2, Edge::Top);
            } else {
                y2 = y1 + pxmin / dx, x2 = xmin;
                step.cut(69, 1, x2, y2, Edge::Left);
            }
        }
    };

    static constexpr std::string_view correctedCode = R"(
display = true
if x1 < xmin: leftColumn(xmin, ymax, xmax, ymin)
else if x1 > xmax: turn leftColumn(-xmax, -ymin, -xmin, -ymax)
else: centreColumn(xmin, ymax, xmax, ymin)
if not display: reject
accept the line from x1, y1 to x2, y2
leftColumn(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false
  else if y1 > ymax: topLeftCorner(xmin, ymax, xmax, ymin)
  else if y1 < ymin: mirror topLeftCorner(xmin, -ymin, xmax, -ymax)
  else: leftEdge(xmin, ymax, xmax, ymin)
topLeftCorner(xmin, ymax, xmax, ymin):
  if y2 > ymax: display = false,  return
  dx = x2-x1,  dy = y2-y1
  pymax = (ymax-y1) * dx,  pxmin = (xmin-x1) * dy
  if pymax > pxmin
    leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin)
  else
    mirror leftBottomRegion(-ymax, -xmin, -ymin, -xmax, -dy, -dx, pymax)
leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin):
  if y2 >= ymin
    if x2 > xmax: y2 = held(y1 + (xmax-x1) * dy / dx),  x2 = xmax
  else
    pymin = (ymin-y1) * dx
    if pymin > pxmin: display = false,  return
    if x2 > xmax
      pxmax = (xmax-x1) * dy
      if pymin > pxmax: x2 = held(x1 + pymin / dy),  y2 = ymin
      else: y2 = held(y1 + pxmax / dx),  x2 = xmax
    else: x2 = held(x1 + pymin / dy),  y2 = ymin
  y1 = held(y1 + pxmin / dx),  x1 = xmin
leftEdge(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false
  else if y2 < ymin: p2Bottom(xmin, ymax, xmax, ymin)
  else if y2 > ymax: mirror p2Bottom(xmin, -ymin, xmax, -ymax)
  else
    dx = x2-x1,  dy = y2-y1
    if x2 > xmax: y2 = held(y1 + dy * (xmax-x1) / dx),  x2 = xmax
    y1 = held(y1 + dy * (xmin-x1) / dx),  x1 = xmin
p2Bottom(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1
  pxmin = (xmin-x1) * dy,  pymin = (ymin-y1) * dx
  if pymin > pxmin: display = false,  return
  if x2 > xmax
    pxmax = (xmax-x1) * dy
    if pymin > pxmax: x2 = held(x1 + pymin / dy),  y2 = ymin
    else: y2 = held(y1 + pxmax / dx),  x2 = xmax
  else: x2 = held(x1 + pymin / dy),  y2 = ymin
  y1 = held(y1 + pxmin / dx),  x1 = xmin
centreColumn(xmin, ymax, xmax, ymin):
  if y1 > ymax: turn leftEdge(-ymax, xmax, -ymin, xmin)
  else if y1 < ymin: turn leftEdge(ymin, -xmin, ymax, -xmax)
  else: inside(xmin, ymax, xmax, ymin)
inside(xmin, ymax, xmax, ymin):
  if x2 < xmin: p2Left(xmin, ymax, xmax, ymin)
  else if x2 > xmax: turn p2Left(-xmax, -ymin, -xmin, -ymax)
  else if y2 > ymax
    x2 = held(x1 + (x2-x1) * (ymax-y1) / (y2-y1)),  y2 = ymax
  else if y2 < ymin
    x2 = held(x1 + (x2-x1) * (ymin-y1) / (y2-y1)),  y2 = ymin
p2Left(xmin, ymax, xmax, ymin):
  if y2 > ymax: p2LeftTop(xmin, ymax, xmax, ymin)
  else if y2 < ymin: turn p2LeftTop(ymin, -xmin, ymax, -xmax)
  else: y2 = held(y1 + (y2-y1) * (xmin-x1) / (x2-x1)),  x2 = xmin
p2LeftTop(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1
  pxmin = dy * (xmin-x1),  pymax = dx * (ymax-y1)
  if pymax > pxmin: x2 = held(x1 + pymax / dy),  y2 = ymax
  else: y2 = held(y1 + pxmin / dx),  x2 = xmin
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        Parameters<T> p{w.min.x, w.max.y, w.max.x, w.min.y, s.a.x, s.a.y, s.b.x, s.b.y, true};
        auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
        step.set("display", display);
        if (step.test(2, x1 < xmin, Edge::Left))
            Corrected::leftColumn(p, step);
        else if (step.test(3, x1 > xmax, Edge::Right)) {
            auto half = turned<HalfTurn>(3, p, step);
            Corrected::leftColumn(half.inside, half.step);
            half.back();
        } else
            Corrected::centreColumn(p, step);
        if (step.test(5, !display))
            return step.reject(5);
        return step.accept(6, BasicSegment<T>{{x1, y1}, {x2, y2}});
    }
    /// The procedures, in the order of the pseudo-code.
    struct Corrected {
        /// End 1 is left of the window.
        static constexpr void leftColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(8, x2 < xmin, Edge::Left))
                display = step.let(8, "display", false, Edge::Left);
            else if (step.test(9, y1 > ymax, Edge::Top))
                topLeftCorner(p, step);
            else if (step.test(10, y1 < ymin, Edge::Bottom)) {
                auto mirrored = turned<MirrorInX>(10, p, step);
                topLeftCorner(mirrored.inside, mirrored.step);
                mirrored.back();
            } else
                leftEdge(p, step);
        }

        /// End 1 is left of the window and above it.
        static constexpr void topLeftCorner(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(13, y2 > ymax, Edge::Top))
                return void(display = step.let(13, "display", false, Edge::Top));
            const auto dx = step.set("dx", x2 - x1), dy = step.let(14, "dy", y2 - y1);
            const auto pymax = step.set("pymax", (ymax - y1) * dx);
            const auto pxmin = step.let(15, "pxmin", (xmin - x1) * dy, Edge::Left);
            if (step.test(16, pymax > pxmin, Edge::Left))
                leftBottomRegion(p, dx, dy, pxmin, step);
            else {
                const auto right = step.set("dx", -dy), up = step.set("dy", -dx);
                step.set("pxmin", pymax);
                auto mirrored = turned<MirrorInDiagonal>(19, p, step);
                leftBottomRegion(mirrored.inside, right, up, pymax, mirrored.step);
                mirrored.back();
            }
        }

        /// End 1 is beyond the top left corner, and the line passes below that corner.
        template <class T>
        // NOLINTNEXTLINE(readability-function-size): nested as in the pseudo-code
        static constexpr void leftBottomRegion(Parameters<T>& p, T dx, T dy, T pxmin, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(21, y2 >= ymin, Edge::Bottom)) {
                if (step.test(22, x2 > xmax, Edge::Right)) {
                    y2 = clamped(y1 + (xmax - x1) * dy / dx, ymin, ymax), x2 = xmax;
                    step.cut(22, 1, x2, y2, Edge::Right);
                }
            } else {
                const T pymin = step.let(24, "pymin", (ymin - y1) * dx, Edge::Bottom);
                if (step.test(25, pymin > pxmin, Edge::Left))
                    return void(display = step.let(25, "display", false, Edge::Bottom));
                if (step.test(26, x2 > xmax, Edge::Right)) {
                    const T pxmax = step.let(27, "pxmax", (xmax - x1) * dy, Edge::Right);
                    if (step.test(28, pymin > pxmax, Edge::Bottom)) {
                        x2 = clamped(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                        step.cut(28, 1, x2, y2, Edge::Bottom);
                    } else {
                        y2 = clamped(y1 + pxmax / dx, ymin, ymax), x2 = xmax;
                        step.cut(29, 1, x2, y2, Edge::Right);
                    }
                } else {
                    x2 = clamped(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                    step.cut(30, 1, x2, y2, Edge::Bottom);
                }
            }
            y1 = clamped(y1 + pxmin / dx, ymin, ymax), x1 = xmin;
            step.cut(31, 0, x1, y1, Edge::Left);
        }

        /// End 1 is left of the window, neither above nor below it.
        static constexpr void leftEdge(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(33, x2 < xmin, Edge::Left))
                display = step.let(33, "display", false, Edge::Left);
            else if (step.test(34, y2 < ymin, Edge::Bottom))
                p2Bottom(p, step);
            else if (step.test(35, y2 > ymax, Edge::Top)) {
                auto mirrored = turned<MirrorInX>(35, p, step);
                p2Bottom(mirrored.inside, mirrored.step);
                mirrored.back();
            } else {
                const auto dx = step.set("dx", x2 - x1), dy = step.let(37, "dy", y2 - y1);
                if (step.test(38, x2 > xmax, Edge::Right)) {
                    y2 = clamped(y1 + dy * (xmax - x1) / dx, ymin, ymax), x2 = xmax;
                    step.cut(38, 1, x2, y2, Edge::Right);
                }
                y1 = clamped(y1 + dy * (xmin - x1) / dx, ymin, ymax), x1 = xmin;
                step.cut(39, 0, x1, y1, Edge::Left);
            }
        }

        /// The same, and End 2 is below the window.
        static constexpr void p2Bottom(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let(41, "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", (xmin - x1) * dy);
            const auto pymin = step.let(42, "pymin", (ymin - y1) * dx, Edge::Bottom);
            if (step.test(43, pymin > pxmin, Edge::Left))
                return void(display = step.let(43, "display", false, Edge::Bottom));
            if (step.test(44, x2 > xmax, Edge::Right)) {
                const auto pxmax = step.let(45, "pxmax", (xmax - x1) * dy, Edge::Right);
                if (step.test(46, pymin > pxmax, Edge::Bottom)) {
                    x2 = clamped(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                    step.cut(46, 1, x2, y2, Edge::Bottom);
                } else {
                    y2 = clamped(y1 + pxmax / dx, ymin, ymax), x2 = xmax;
                    step.cut(47, 1, x2, y2, Edge::Right);
                }
            } else {
                x2 = clamped(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                step.cut(48, 1, x2, y2, Edge::Bottom);
            }
            y1 = clamped(y1 + pxmin / dx, ymin, ymax), x1 = xmin;
            step.cut(49, 0, x1, y1, Edge::Left);
        }

        /// End 1 is neither left nor right of the window.
        static constexpr void centreColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(51, y1 > ymax, Edge::Top)) {
                auto left = turned<ThreeQuarterTurn>(51, p, step);
                leftEdge(left.inside, left.step);
                left.back();
            } else if (step.test(52, y1 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>(52, p, step);
                leftEdge(right.inside, right.step);
                right.back();
            } else
                inside(p, step);
        }

        /// End 1 is inside the window.
        static constexpr void inside(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(55, x2 < xmin, Edge::Left))
                p2Left(p, step);
            else if (step.test(56, x2 > xmax, Edge::Right)) {
                auto half = turned<HalfTurn>(56, p, step);
                p2Left(half.inside, half.step);
                half.back();
            } else if (step.test(57, y2 > ymax, Edge::Top)) {
                x2 = clamped(x1 + (x2 - x1) * (ymax - y1) / (y2 - y1), xmin, xmax), y2 = ymax;
                step.cut(58, 1, x2, y2, Edge::Top);
            } else if (step.test(59, y2 < ymin, Edge::Bottom)) {
                x2 = clamped(x1 + (x2 - x1) * (ymin - y1) / (y2 - y1), xmin, xmax), y2 = ymin;
                step.cut(60, 1, x2, y2, Edge::Bottom);
            }
        }

        /// End 1 is inside the window, End 2 left of it.
        static constexpr void p2Left(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test(62, y2 > ymax, Edge::Top))
                p2LeftTop(p, step);
            else if (step.test(63, y2 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>(63, p, step);
                p2LeftTop(right.inside, right.step);
                right.back();
            } else {
                y2 = clamped(y1 + (y2 - y1) * (xmin - x1) / (x2 - x1), ymin, ymax), x2 = xmin;
                step.cut(64, 1, x2, y2, Edge::Left);
            }
        }

        /// End 1 is inside the window, End 2 left of it and above it.
        static constexpr void p2LeftTop(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let(66, "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", dy * (xmin - x1));
            const auto pymax = step.let(67, "pymax", dx * (ymax - y1), Edge::Top);
            if (step.test(68, pymax > pxmin, Edge::Top)) {
                x2 = clamped(x1 + pymax / dy, xmin, xmax), y2 = ymax;
                step.cut(68, 1, x2, y2, Edge::Top);
            } else {
                y2 = clamped(y1 + pxmin / dx, ymin, ymax), x2 = xmin;
                step.cut(69, 1, x2, y2, Edge::Left);
            }
        }
    };
};

template Algorithm describe<NichollLeeNicholl>();

} // namespace clipping
