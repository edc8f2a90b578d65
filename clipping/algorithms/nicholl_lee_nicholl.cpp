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
#include "clipping/fixed_text.h"
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
        std::string_view call; ///< its label
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
            outsideStep.left(call, BasicSegment<T>{a, b});
        }
    };

    /// Transforms window and ends for a call.
    template <class Symmetry, class T, class Step>
    static constexpr Turned<Symmetry, T, Step> turned(std::string_view call, Parameters<T>& p,
                                                      Step& step)
    {
        using V = glm::vec<2, T>;
        const auto w = Symmetry::window(BasicWindow<T>{{p.xmin, p.ymin}, {p.xmax, p.ymax}});
        const V a = Symmetry::of(V(p.x1, p.y1)), b = Symmetry::of(V(p.x2, p.y2));
        const Parameters<T> inside{w.min.x, w.max.y, w.max.x, w.min.y,  a.x,
                                   a.y,     b.x,     b.y,     p.display};
        tell(inside, step);
        step.let(call, "ymin", inside.ymin);
        return {call, p, step, inside, turnedStep<typename Symmetry::Inverse>(step)};
    }

    /// Reports the parameters of a procedure, except ymin.
    template <class T>
    static constexpr void tell(const Parameters<T>& p, auto& step)
    {
        step.set("xmin", p.xmin), step.set("ymax", p.ymax), step.set("xmax", p.xmax);
        step.set("x1", p.x1), step.set("y1", p.y1), step.set("x2", p.x2), step.set("y2", p.y2);
    }

    static constexpr std::string_view correctedCode = R"(
display = true
if x1 < xmin: leftColumn(xmin, ymax, xmax, ymin)  #left
else if x1 > xmax: turn leftColumn(-xmax, -ymin, -xmin, -ymax)  #right
else: centreColumn(xmin, ymax, xmax, ymin)
if not display: reject  #hidden
accept the line from x1, y1 to x2, y2  #accept
leftColumn(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false  #bothLeft
  else if y1 > ymax: topLeftCorner(xmin, ymax, xmax, ymin)  #leftAbove
  else if y1 < ymin: mirror topLeftCorner(xmin, -ymin, xmax, -ymax)  #leftBelow
  else: leftEdge(xmin, ymax, xmax, ymin)
topLeftCorner(xmin, ymax, xmax, ymin):
  if y2 > ymax: display = false,  return  #bothAbove
  dx = x2-x1,  dy = y2-y1  #cornerExtent
  pymax = (ymax-y1) * dx,  pxmin = (xmin-x1) * dy  #cornerProducts
  if pymax > pxmin  #cornerSide
    leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin)
  else
    mirror leftBottomRegion(-ymax, -xmin, -ymin, -xmax, -dy, -dx, pymax)  #mirrorCorner
leftBottomRegion(xmin, ymax, xmax, ymin, dx, dy, pxmin):
  if y2 >= ymin  #notBelow
    if x2 > xmax: y2 = held(y1 + (xmax-x1) * dy / dx),  x2 = xmax  #cornerRight
  else
    pymin = (ymin-y1) * dx  #cornerBottom
    if pymin > pxmin: display = false,  return  #cornerMisses
    if x2 > xmax  #cornerBeyond
      pxmax = (xmax-x1) * dy  #cornerFar
      if pymin > pxmax: x2 = held(x1 + pymin / dy),  y2 = ymin  #cornerToBottom
      else: y2 = held(y1 + pxmax / dx),  x2 = xmax  #cornerToRight
    else: x2 = held(x1 + pymin / dy),  y2 = ymin  #cornerDown
  y1 = held(y1 + pxmin / dx),  x1 = xmin  #cornerEnters
leftEdge(xmin, ymax, xmax, ymin):
  if x2 < xmin: display = false  #edgeBothLeft
  else if y2 < ymin: p2Bottom(xmin, ymax, xmax, ymin)  #edgeBelow
  else if y2 > ymax: mirror p2Bottom(xmin, -ymin, xmax, -ymax)  #edgeAbove
  else
    dx = x2-x1,  dy = y2-y1  #edgeExtent
    if x2 > xmax: y2 = held(y1 + dy * (xmax-x1) / dx),  x2 = xmax  #edgeRight
    y1 = held(y1 + dy * (xmin-x1) / dx),  x1 = xmin  #edgeEnters
p2Bottom(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1  #bottomExtent
  pxmin = (xmin-x1) * dy,  pymin = (ymin-y1) * dx  #bottomProducts
  if pymin > pxmin: display = false,  return  #bottomMisses
  if x2 > xmax  #bottomBeyond
    pxmax = (xmax-x1) * dy  #bottomFar
    if pymin > pxmax: x2 = held(x1 + pymin / dy),  y2 = ymin  #bottomToBottom
    else: y2 = held(y1 + pxmax / dx),  x2 = xmax  #bottomToRight
  else: x2 = held(x1 + pymin / dy),  y2 = ymin  #bottomDown
  y1 = held(y1 + pxmin / dx),  x1 = xmin  #bottomEnters
centreColumn(xmin, ymax, xmax, ymin):
  if y1 > ymax: turn leftEdge(-ymax, xmax, -ymin, xmin)  #above
  else if y1 < ymin: turn leftEdge(ymin, -xmin, ymax, -xmax)  #below
  else: inside(xmin, ymax, xmax, ymin)
inside(xmin, ymax, xmax, ymin):
  if x2 < xmin: p2Left(xmin, ymax, xmax, ymin)  #insideLeft
  else if x2 > xmax: turn p2Left(-xmax, -ymin, -xmin, -ymax)  #insideRight
  else if y2 > ymax  #insideAbove
    x2 = held(x1 + (x2-x1) * (ymax-y1) / (y2-y1)),  y2 = ymax  #insideToTop
  else if y2 < ymin  #insideBelow
    x2 = held(x1 + (x2-x1) * (ymin-y1) / (y2-y1)),  y2 = ymin  #insideToBottom
p2Left(xmin, ymax, xmax, ymin):
  if y2 > ymax: p2LeftTop(xmin, ymax, xmax, ymin)  #leftTop
  else if y2 < ymin: turn p2LeftTop(ymin, -xmin, ymax, -xmax)  #leftBottom
  else: y2 = held(y1 + (y2-y1) * (xmin-x1) / (x2-x1)),  x2 = xmin  #leftDirect
p2LeftTop(xmin, ymax, xmax, ymin):
  dx = x2-x1,  dy = y2-y1  #leftExtent
  pxmin = dy * (xmin-x1),  pymax = dx * (ymax-y1)  #leftProducts
  if pymax > pxmin: x2 = held(x1 + pymax / dy),  y2 = ymax  #leftToTop
  else: y2 = held(y1 + pxmin / dx),  x2 = xmin  #leftToLeft
)";
    /// The paper's text has the same lines without held().
    static constexpr auto publishedText = [] {
        FixedText<correctedCode.size()> text;
        int open = 0; // parentheses since "held", its own included
        for (std::size_t i = 0; i < correctedCode.size(); ++i) {
            const std::string_view rest = correctedCode.substr(i), letter = rest.substr(0, 1);
            if (rest.starts_with("held("))
                i += 4, open = 1;
            else if (open == 0 || (letter == "(" && ++open > 0) || letter != ")" || --open > 0)
                text.add(letter);
        }
        return text;
    }();
    static constexpr std::string_view publishedCode = publishedText.view();

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        return clip<[](const auto& v, const auto&, const auto&) { return v; }>(s, w, step);
    }
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        return clip<[](const auto& v, const auto& min, const auto& max) {
            return clamped(v, min, max);
        }>(s, w, step);
    }

    template <auto held, class T>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, auto& step)
    {
        Parameters<T> p{w.min.x, w.max.y, w.max.x, w.min.y, s.a.x, s.a.y, s.b.x, s.b.y, true};
        auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
        step.set("display", display);
        if (step.test("left", x1 < xmin, Edge::Left))
            Procedures<held>::leftColumn(p, step);
        else if (step.test("right", x1 > xmax, Edge::Right)) {
            auto half = turned<HalfTurn>("right", p, step);
            Procedures<held>::leftColumn(half.inside, half.step);
            half.back();
        } else
            Procedures<held>::centreColumn(p, step);
        if (step.test("hidden", !display))
            return step.reject("hidden");
        return step.accept("accept", BasicSegment<T>{{x1, y1}, {x2, y2}});
    }
    /// The procedures, in the order of the pseudo-code. `held` is all that the forms differ in: it
    /// takes the coordinate of a new end that is not its edge's own, and the window's range on its
    /// axis.
    template <auto held>
    struct Procedures {
        /// End 1 is left of the window.
        static constexpr void leftColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("bothLeft", x2 < xmin, Edge::Left))
                display = step.let("bothLeft", "display", false, Edge::Left);
            else if (step.test("leftAbove", y1 > ymax, Edge::Top))
                topLeftCorner(p, step);
            else if (step.test("leftBelow", y1 < ymin, Edge::Bottom)) {
                auto mirrored = turned<MirrorInX>("leftBelow", p, step);
                topLeftCorner(mirrored.inside, mirrored.step);
                mirrored.back();
            } else
                leftEdge(p, step);
        }

        /// End 1 is left of the window and above it.
        static constexpr void topLeftCorner(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("bothAbove", y2 > ymax, Edge::Top))
                return void(display = step.let("bothAbove", "display", false, Edge::Top));
            const auto dx = step.set("dx", x2 - x1), dy = step.let("cornerExtent", "dy", y2 - y1);
            const auto pymax = step.set("pymax", (ymax - y1) * dx);
            const auto pxmin = step.let("cornerProducts", "pxmin", (xmin - x1) * dy, Edge::Left);
            if (step.test("cornerSide", pymax > pxmin, Edge::Left))
                leftBottomRegion(p, dx, dy, pxmin, step);
            else {
                const auto right = step.set("dx", -dy), up = step.set("dy", -dx);
                step.set("pxmin", pymax);
                auto mirrored = turned<MirrorInDiagonal>("mirrorCorner", p, step);
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
            if (step.test("notBelow", y2 >= ymin, Edge::Bottom)) {
                if (step.test("cornerRight", x2 > xmax, Edge::Right)) {
                    y2 = held(y1 + (xmax - x1) * dy / dx, ymin, ymax), x2 = xmax;
                    step.cut("cornerRight", 1, x2, y2, Edge::Right);
                }
            } else {
                const T pymin = step.let("cornerBottom", "pymin", (ymin - y1) * dx, Edge::Bottom);
                if (step.test("cornerMisses", pymin > pxmin, Edge::Left))
                    return void(display = step.let("cornerMisses", "display", false, Edge::Bottom));
                if (step.test("cornerBeyond", x2 > xmax, Edge::Right)) {
                    const T pxmax = step.let("cornerFar", "pxmax", (xmax - x1) * dy, Edge::Right);
                    if (step.test("cornerToBottom", pymin > pxmax, Edge::Bottom)) {
                        x2 = held(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                        step.cut("cornerToBottom", 1, x2, y2, Edge::Bottom);
                    } else {
                        y2 = held(y1 + pxmax / dx, ymin, ymax), x2 = xmax;
                        step.cut("cornerToRight", 1, x2, y2, Edge::Right);
                    }
                } else {
                    x2 = held(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                    step.cut("cornerDown", 1, x2, y2, Edge::Bottom);
                }
            }
            y1 = held(y1 + pxmin / dx, ymin, ymax), x1 = xmin;
            step.cut("cornerEnters", 0, x1, y1, Edge::Left);
        }

        /// End 1 is left of the window, neither above nor below it.
        static constexpr void leftEdge(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("edgeBothLeft", x2 < xmin, Edge::Left))
                display = step.let("edgeBothLeft", "display", false, Edge::Left);
            else if (step.test("edgeBelow", y2 < ymin, Edge::Bottom))
                p2Bottom(p, step);
            else if (step.test("edgeAbove", y2 > ymax, Edge::Top)) {
                auto mirrored = turned<MirrorInX>("edgeAbove", p, step);
                p2Bottom(mirrored.inside, mirrored.step);
                mirrored.back();
            } else {
                const auto dx = step.set("dx", x2 - x1), dy = step.let("edgeExtent", "dy", y2 - y1);
                if (step.test("edgeRight", x2 > xmax, Edge::Right)) {
                    y2 = held(y1 + dy * (xmax - x1) / dx, ymin, ymax), x2 = xmax;
                    step.cut("edgeRight", 1, x2, y2, Edge::Right);
                }
                y1 = held(y1 + dy * (xmin - x1) / dx, ymin, ymax), x1 = xmin;
                step.cut("edgeEnters", 0, x1, y1, Edge::Left);
            }
        }

        /// The same, and End 2 is below the window.
        static constexpr void p2Bottom(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let("bottomExtent", "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", (xmin - x1) * dy);
            const auto pymin = step.let("bottomProducts", "pymin", (ymin - y1) * dx, Edge::Bottom);
            if (step.test("bottomMisses", pymin > pxmin, Edge::Left))
                return void(display = step.let("bottomMisses", "display", false, Edge::Bottom));
            if (step.test("bottomBeyond", x2 > xmax, Edge::Right)) {
                const auto pxmax = step.let("bottomFar", "pxmax", (xmax - x1) * dy, Edge::Right);
                if (step.test("bottomToBottom", pymin > pxmax, Edge::Bottom)) {
                    x2 = held(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                    step.cut("bottomToBottom", 1, x2, y2, Edge::Bottom);
                } else {
                    y2 = held(y1 + pxmax / dx, ymin, ymax), x2 = xmax;
                    step.cut("bottomToRight", 1, x2, y2, Edge::Right);
                }
            } else {
                x2 = held(x1 + pymin / dy, xmin, xmax), y2 = ymin;
                step.cut("bottomDown", 1, x2, y2, Edge::Bottom);
            }
            y1 = held(y1 + pxmin / dx, ymin, ymax), x1 = xmin;
            step.cut("bottomEnters", 0, x1, y1, Edge::Left);
        }

        /// End 1 is neither left nor right of the window.
        static constexpr void centreColumn(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("above", y1 > ymax, Edge::Top)) {
                auto left = turned<ThreeQuarterTurn>("above", p, step);
                leftEdge(left.inside, left.step);
                left.back();
            } else if (step.test("below", y1 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>("below", p, step);
                leftEdge(right.inside, right.step);
                right.back();
            } else
                inside(p, step);
        }

        /// End 1 is inside the window.
        static constexpr void inside(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("insideLeft", x2 < xmin, Edge::Left))
                p2Left(p, step);
            else if (step.test("insideRight", x2 > xmax, Edge::Right)) {
                auto half = turned<HalfTurn>("insideRight", p, step);
                p2Left(half.inside, half.step);
                half.back();
            } else if (step.test("insideAbove", y2 > ymax, Edge::Top)) {
                x2 = held(x1 + (x2 - x1) * (ymax - y1) / (y2 - y1), xmin, xmax), y2 = ymax;
                step.cut("insideToTop", 1, x2, y2, Edge::Top);
            } else if (step.test("insideBelow", y2 < ymin, Edge::Bottom)) {
                x2 = held(x1 + (x2 - x1) * (ymin - y1) / (y2 - y1), xmin, xmax), y2 = ymin;
                step.cut("insideToBottom", 1, x2, y2, Edge::Bottom);
            }
        }

        /// End 1 is inside the window, End 2 left of it.
        static constexpr void p2Left(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            if (step.test("leftTop", y2 > ymax, Edge::Top))
                p2LeftTop(p, step);
            else if (step.test("leftBottom", y2 < ymin, Edge::Bottom)) {
                auto right = turned<QuarterTurn>("leftBottom", p, step);
                p2LeftTop(right.inside, right.step);
                right.back();
            } else {
                y2 = held(y1 + (y2 - y1) * (xmin - x1) / (x2 - x1), ymin, ymax), x2 = xmin;
                step.cut("leftDirect", 1, x2, y2, Edge::Left);
            }
        }

        /// End 1 is inside the window, End 2 left of it and above it.
        static constexpr void p2LeftTop(auto& p, auto& step)
        {
            auto& [xmin, ymax, xmax, ymin, x1, y1, x2, y2, display] = p;
            const auto dx = step.set("dx", x2 - x1), dy = step.let("leftExtent", "dy", y2 - y1);
            const auto pxmin = step.set("pxmin", dy * (xmin - x1));
            const auto pymax = step.let("leftProducts", "pymax", dx * (ymax - y1), Edge::Top);
            if (step.test("leftToTop", pymax > pxmin, Edge::Top)) {
                x2 = held(x1 + pymax / dy, xmin, xmax), y2 = ymax;
                step.cut("leftToTop", 1, x2, y2, Edge::Top);
            } else {
                y2 = held(y1 + pxmin / dx, ymin, ymax), x2 = xmin;
                step.cut("leftToLeft", 1, x2, y2, Edge::Left);
            }
        }
    };
};

template Algorithm describe<NichollLeeNicholl>();

} // namespace clipping
