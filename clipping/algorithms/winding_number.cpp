// SPDX-License-Identifier: MIT
//
// Winding number, the textbook method for polygons of any shape; here for the four edges of a
// window. It has no printed form to compare with: textbooks describe the idea and leave the special
// cases, rounding and closed borders to the reader. polygon/winding_number.cpp and
// region/winding_number.cpp are the same method for convex polygons and for areas of any shape.
//
// A point is inside if the border winds round it, counter-clockwise once here. Along the line that
// number changes only where the line crosses an edge: by +1 where it passes from the edge's right
// to its left, by -1 on the way back. Orientation tests of an edge's two corners tell whether the
// line crosses it, and those of the segment's ends, here single comparisons, tell whether it does
// so before End 1, on the segment or after End 2.
//
// Corners on the line need a rule. If a corner is strictly left, all others count as right: as if
// the line were moved to its left by infinitely little, where no corner is on it and every edge is
// crossed properly or not at all. If none is left, those on the line count as left: the line is
// moved to its right. So a window that is only touched is crossed as well, in one point or along
// one edge. A window whose corners are all on the line has no inside; the common part is then that
// of two intervals.
//
// Error. All decisions are exact (exact/turn.h), and every new coordinate is the exact one, rounded
// once (exact/line.h): k = 1/2. As rounding is monotone, a new end is inside the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/exact/line_through.h"
#include "clipping/ieee_numbers.h"
#include "clipping/polygon/uses.h"

#include <algorithm>
#include <array>

namespace clipping {

struct WindingNumber {
    static constexpr About about{
        .key = "winding-number",
        .abbreviation = "WN",
        .name = "Winding number",
        .year = 1962,
        .idea = "Count how often the border winds round the points of the line; the number changes "
                "only where the line crosses an edge.",
        .ulps = 0.5,
    };

    static constexpr bool ours = true;     // no published form
    static constexpr bool unframed = true; // it handles all finite numbers itself
    static constexpr const auto* polygon = &windingNumberPolygon;

    static constexpr std::string_view correctedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
s[1] = side(xmin, ymin),  s[2] = side(xmax, ymin)  #sides12
s[3] = side(xmax, ymax),  s[4] = side(xmin, ymax)  #sides34
most = max(max(s[1], s[2]), max(s[3], s[4]))  #most
w = 0  #zero
if s[1] == 0 and s[2] == 0 and s[3] == 0 and s[4] == 0  #allOnLine
  if (x1 < xmin and x2 < xmin) or (x1 > xmax and x2 > xmax)  #besideX
    reject  #rejectX
  if (y1 < ymin and y2 < ymin) or (y1 > ymax and y2 > ymax)  #besideY
    reject  #rejectY
  hold both ends in the window  #hold
  accept  #acceptHeld
for i = 1, 2, 3, 4
  j = i < 4 ? i+1 : 1,  level = i == 1 or i == 3  #edge
  if s[i] == most and s[j] != most and not beyond(x2, y2)  #enters
    w = w+1  #countUp
    if beyond(x1, y1)  #end1
      x[1] = level ? xAt(Y[i]) : X[i],  y[1] = level ? Y[i] : yAt(X[i])  #move1
  if s[i] != most and s[j] == most and beyond(x2, y2)  #leaves
    if beyond(x1, y1)  #notEntered
      w = w-1  #countDown
    else
      x[2] = level ? xAt(Y[i]) : X[i],  y[2] = level ? Y[i] : yAt(X[i])  #move2
if w == 0  #missed
  reject  #reject
accept the line from x[1], y[1] to x[2], y[2]  #accept
X[1] = xmin,  Y[1] = ymin
X[2] = xmax,  Y[2] = ymin
X[3] = xmax,  Y[3] = ymax
X[4] = xmin,  Y[4] = ymax
)";
    /// From corner (X, Y) to the next one. The window is on its left.
    template <class T>
    struct Border {
        Edge edge;
        T X, Y;

        bool isLevel() const { return edge == Edge::Bottom || edge == Edge::Top; }
        bool isBeyond(const glm::vec<2, T>& p) const
        {
            switch (edge) {
            case Edge::Bottom:
                return p.y < Y;
            case Edge::Right:
                return p.x > X;
            case Edge::Top:
                return p.y > Y;
            default:
                return p.x < X;
            }
        }
        glm::vec<2, T> crossing(const LineThrough<T>& line) const
        {
            return isLevel() ? glm::vec<2, T>{line.xAt(Y), Y} : glm::vec<2, T>{X, line.yAt(X)};
        }
    };

    /// The line enters through an edge, unless End 2 comes before.
    template <class T, class Step>
    static int enter(int w, BasicSegment<T>& visible, const BasicSegment<T>& s,
                     const Border<T>& border, Step& step)
    {
        w = step.let("countUp", "w", w + 1, border.edge);
        if (step.test("end1", border.isBeyond(s.a), border.edge)) {
            visible.a = border.crossing(LineThrough(s));
            step.cut("move1", 0, visible.a, border.edge);
        }
        return w;
    }
    /// The line leaves through an edge, before End 2.
    template <class T, class Step>
    static int leave(int w, BasicSegment<T>& visible, const BasicSegment<T>& s,
                     const Border<T>& border, Step& step)
    {
        if (step.test("notEntered", border.isBeyond(s.a), border.edge))
            return step.let("countDown", "w", w - 1, border.edge);
        visible.b = border.crossing(LineThrough(s));
        step.cut("move2", 1, visible.b, border.edge);
        return w;
    }

    /// All corners are on the line, or the segment is a point.
    template <class T, class Step>
    static std::optional<BasicSegment<T>> commonPart(const BasicSegment<T>& s,
                                                     const BasicWindow<T>& window, Step& step)
    {
        const auto& [a, b] = s;
        const auto& [min, max] = window;
        if (step.test("besideX", (a.x < min.x && b.x < min.x) || (a.x > max.x && b.x > max.x),
                      Edge::Left, Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY", (a.y < min.y && b.y < min.y) || (a.y > max.y && b.y > max.y),
                      Edge::Bottom, Edge::Top))
            return step.reject("rejectY");
        const BasicSegment<T> common{clamped(a, window), clamped(b, window)};
        step.left("hold", common);
        return step.accept("acceptHeld", common);
    }

    template <class T, class Step>
    static std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                    const BasicWindow<T>& window, Step&& step)
    {
        const T xmin = window.min.x, ymin = window.min.y, xmax = window.max.x, ymax = window.max.y;
        const std::array<Border<T>, 4> borders{{{Edge::Bottom, xmin, ymin},
                                                {Edge::Right, xmax, ymin},
                                                {Edge::Top, xmax, ymax},
                                                {Edge::Left, xmin, ymax}}};
        const LineThrough line(s);
        const std::array sides{step.set("s[1]", line.side(xmin, ymin)),
                               step.let("sides12", "s[2]", line.side(xmax, ymin)),
                               step.set("s[3]", line.side(xmax, ymax)),
                               step.let("sides34", "s[4]", line.side(xmin, ymax))};
        const int most = step.let("most", "most", std::ranges::max(sides));
        int w = step.let("zero", "w", 0);
        if (step.test("allOnLine", most == 0 && std::ranges::min(sides) == 0))
            return commonPart(s, window, step);
        BasicSegment<T> visible = s;
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t j = (i + 1) % 4;
            const Border<T>& border = borders[i];
            step.set("i", int(i + 1)), step.set("X[i]", border.X), step.set("Y[i]", border.Y);
            step.set("j", int(j + 1)), step.let("edge", "level", border.isLevel(), border.edge);
            const bool isLeft = sides[i] == most, isNextLeft = sides[j] == most;
            if (step.test("enters", isLeft && !isNextLeft && !border.isBeyond(s.b), border.edge))
                w = enter(w, visible, s, border, step);
            if (step.test("leaves", !isLeft && isNextLeft && border.isBeyond(s.b), border.edge))
                w = leave(w, visible, s, border, step);
        }
        if (step.test("missed", w == 0))
            return step.reject("reject");
        return step.accept("accept", visible);
    }
};

template Algorithm describe<WindingNumber>();

} // namespace clipping
