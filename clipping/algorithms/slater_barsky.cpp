// SPDX-License-Identifier: MIT
//
// Slater-Barsky (1994).
//
//   M. Slater, B. A. Barsky: 2D Line and Polygon Clipping Based on Space Subdivision.
//   The Visual Computer 10, 1994, 407-422.
//
// Published: the function CLIPLINE of the program EnergyPlus, which implements the paper; only
// parts of the paper itself were available. CLIPLINE repeats the first lines for each cell, and
// tests dy > 0 once for the whole walk. Where the pseudo-code has c <= 3, CLIPLINE tests c == 3 and
// loops forever if y2 is NaN. Corrected: the ends of an axis-parallel segment are clamped to the
// window, so that there is no division by 0; a tie at a corner goes towards the window; the sign of
// dy is tested once; a new end is clamped to the window on the side where rounding may have left it
// outside.
//
// The walk goes to the right, from End a to End b. c is its current cell: 3*row + col. Column 0 is
// left of the window, column 1 above, in or below it; row 0 is below the window, row 1 beside or in
// it, row 2 above. The walk never goes further right.
//
// Error. Let e = 2^-53 and M as in README.md. In units of dx*dy the error term is a sum of
// parameters, t(x) - t(y), of which those that are visible or compared are between 0 and 1. It
// starts with two products; each step to another cell adds one, and there are at most two such
// steps before the last test. Each product is off by 3e of itself, and they add up to t(x) + t(y)
// <= 2: 6e; three sums of at most 1 are off by e each: 9e in all. A wrong decision therefore needs
// two points of the segment that are 9e*D apart, D <= 2M being its extent: 18 ulps. A new end is
// off by the same, by the quotient's rounding (2 ulps, for it is no longer than 2M) and by that of
// the last sum (1): 21 ulps. Both together are 39, and 40 leaves one for terms of second order.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

#include <compare>

namespace clipping {

struct SlaterBarsky {
    static constexpr About about{
        .key = "slater-barsky",
        .abbreviation = "SB",
        .name = "Slater-Barsky",
        .year = 1994,
        .idea = "Walk along the segment from one of nine cells to the next; an error term tells "
                "through which side it leaves a cell.",
        .ulps = 40,
    };

    /// The window's edge that is collinear with a cell's right side.
    static constexpr Edge rightOf(int c) { return c % 3 == 0 ? Edge::Left : Edge::Right; }

    static constexpr std::string_view publishedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
a = 1,  b = 2
if x1 > x2  #swap
  a = 2,  b = 1
if x[a] > xmax or x[b] < xmin: reject  #besideX
col = 1,  X = xmax
if x[a] < xmin  #left
  col = 0,  X = xmin
row = 1
if y[a] < ymin  #below
  if y[b] < ymin: reject  #bothBelow
  row = 0
else if y[a] > ymax  #above
  if y[b] > ymax: reject  #bothAbove
  row = 2
c = 3*row + col  #cell
if c == 4 and x[b] <= xmax and y[b] >= ymin and y[b] <= ymax: accept  #inside
dx = x[b]-x[a],  dy = y[b]-y[a]  #extent
Y = row == 0 ? ymin : row == 2 or dy > 0 ? ymax : ymin  #Y
e = dy*(X-x[a]) + dx*(y[a]-Y)  #e
repeat
  if dy > 0  #up
    if e < 0  #upRight
      if c == 1: reject  #upMissesRight
      else if c == 3  #upFromLeft
        x[a] = xmin,  y[a] = ymax + e/dx  #upAtLeft
        if x[b] <= xmax and y[b] <= ymax: accept  #upEndsLeft
      else if c == 4  #upToRight
        x[b] = xmax,  y[b] = ymax + e/dx  #upAtRight
        accept the line from x[1], y[1] to x[2], y[2]  #upAcceptRight
      e = e + dy*(xmax-xmin),  c = c+1  #upGoRight
    else
      if c == 3: reject  #upMissesTop
      else if c == 1  #upFromBottom
        x[a] = xmax - e/dy,  y[a] = ymin  #upAtBottom
        if x[b] <= xmax and y[b] <= ymax: accept  #upEndsBottom
      else if c == 4  #upToTop
        x[b] = xmax - e/dy,  y[b] = ymax  #upAtTop
        accept the line from x[1], y[1] to x[2], y[2]  #upAcceptTop
      e = e - dx*(ymax-ymin),  c = c+3  #goUp
  else
    if e >= 0  #downRight
      if c == 7: reject  #downMissesRight
      else if c == 3  #downFromLeft
        x[a] = xmin,  y[a] = ymin + e/dx  #downAtLeft
        if x[b] <= xmax and y[b] >= ymin: accept  #downEndsLeft
      else if c == 4  #downToRight
        x[b] = xmax,  y[b] = ymin + e/dx  #downAtRight
        accept the line from x[1], y[1] to x[2], y[2]  #downAcceptRight
      e = e + dy*(xmax-xmin),  c = c+1  #downGoRight
    else
      if c <= 3: reject  #downMissesBottom
      else if c == 7  #downFromTop
        x[a] = xmax - e/dy,  y[a] = ymax  #downAtTop
        if x[b] <= xmax and y[b] >= ymin: accept  #downEndsTop
      else if c == 4  #downToBottom
        x[b] = xmax - e/dy,  y[b] = ymin  #downAtBottom
        accept the line from x[1], y[1] to x[2], y[2]  #downAcceptBottom
      e = e + dx*(ymax-ymin),  c = c-3  #goDown
)";
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): one function, as EnergyPlus has it
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const bool swapped = step.test("swap", x1 > x2);
        const int a = swapped ? 1 : 0, b = swapped ? 0 : 1;
        step.set("a", a + 1), step.set("b", b + 1);
        // x[a], y[a], x[b], y[b]: an array indexed by a would cost a fifth of the time.
        T xa = swapped ? x2 : x1, ya = swapped ? y2 : y1;
        T xb = swapped ? x1 : x2, yb = swapped ? y1 : y2;
        if (step.test("besideX", xa > xmax || xb < xmin, Edge::Right, Edge::Left))
            return step.reject("besideX");
        const bool isLeft = step.test("left", xa < xmin, Edge::Left);
        const int col = step.set("col", isLeft ? 0 : 1);
        const T X = step.set("X", isLeft ? xmin : xmax);
        int row = step.set("row", 1);
        if (step.test("below", ya < ymin, Edge::Bottom)) {
            if (step.test("bothBelow", yb < ymin, Edge::Bottom))
                return step.reject("bothBelow");
            row = step.set("row", 0);
        } else if (step.test("above", ya > ymax, Edge::Top)) {
            if (step.test("bothAbove", yb > ymax, Edge::Top))
                return step.reject("bothAbove");
            row = step.set("row", 2);
        }
        int c = step.let("cell", "c", 3 * row + col);
        if (step.test("inside", c == 4 && xb <= xmax && yb >= ymin && yb <= ymax))
            return step.accept("inside", s);
        const T dx = step.set("dx", xb - xa), dy = step.let("extent", "dy", yb - ya);
        const T Y = step.let("Y", "Y", row == 0 ? ymin : row == 2 || dy > T(0) ? ymax : ymin);
        T e = step.let("e", "e", dy * (X - xa) + dx * (ya - Y));
        const auto visible = [&] {
            return swapped ? BasicSegment<T>{{xb, yb}, {xa, ya}}
                           : BasicSegment<T>{{xa, ya}, {xb, yb}};
        };
        for (;;) {
            if (step.test("up", dy > T(0))) {
                if (step.test("upRight", e < T(0), rightOf(c))) {
                    if (step.test("upMissesRight", c == 1)) {
                        return step.reject("upMissesRight");
                    } else if (step.test("upFromLeft", c == 3)) {
                        xa = xmin, ya = ymax + e / dx;
                        step.cut("upAtLeft", a, xa, ya, Edge::Left);
                        if (step.test("upEndsLeft", xb <= xmax && yb <= ymax))
                            return step.accept("upEndsLeft", visible());
                    } else if (step.test("upToRight", c == 4)) {
                        xb = xmax, yb = ymax + e / dx;
                        step.cut("upAtRight", b, xb, yb, Edge::Right);
                        return step.accept("upAcceptRight", visible());
                    }
                    e = step.set("e", e + dy * (xmax - xmin)),
                    c = step.let("upGoRight", "c", c + 1);
                } else {
                    if (step.test("upMissesTop", c == 3)) {
                        return step.reject("upMissesTop");
                    } else if (step.test("upFromBottom", c == 1)) {
                        xa = xmax - e / dy, ya = ymin;
                        step.cut("upAtBottom", a, xa, ya, Edge::Bottom);
                        if (step.test("upEndsBottom", xb <= xmax && yb <= ymax))
                            return step.accept("upEndsBottom", visible());
                    } else if (step.test("upToTop", c == 4)) {
                        xb = xmax - e / dy, yb = ymax;
                        step.cut("upAtTop", b, xb, yb, Edge::Top);
                        return step.accept("upAcceptTop", visible());
                    }
                    e = step.set("e", e - dx * (ymax - ymin)), c = step.let("goUp", "c", c + 3);
                }
            } else {
                if (step.test("downRight", e >= T(0), rightOf(c))) {
                    if (step.test("downMissesRight", c == 7)) {
                        return step.reject("downMissesRight");
                    } else if (step.test("downFromLeft", c == 3)) {
                        xa = xmin, ya = ymin + e / dx;
                        step.cut("downAtLeft", a, xa, ya, Edge::Left);
                        if (step.test("downEndsLeft", xb <= xmax && yb >= ymin))
                            return step.accept("downEndsLeft", visible());
                    } else if (step.test("downToRight", c == 4)) {
                        xb = xmax, yb = ymin + e / dx;
                        step.cut("downAtRight", b, xb, yb, Edge::Right);
                        return step.accept("downAcceptRight", visible());
                    }
                    e = step.set("e", e + dy * (xmax - xmin)),
                    c = step.let("downGoRight", "c", c + 1);
                } else {
                    if (step.test("downMissesBottom", c <= 3)) {
                        return step.reject("downMissesBottom");
                    } else if (step.test("downFromTop", c == 7)) {
                        xa = xmax - e / dy, ya = ymax;
                        step.cut("downAtTop", a, xa, ya, Edge::Top);
                        if (step.test("downEndsTop", xb <= xmax && yb >= ymin))
                            return step.accept("downEndsTop", visible());
                    } else if (step.test("downToBottom", c == 4)) {
                        xb = xmax - e / dy, yb = ymin;
                        step.cut("downAtBottom", b, xb, yb, Edge::Bottom);
                        return step.accept("downAcceptBottom", visible());
                    }
                    e = step.set("e", e + dx * (ymax - ymin)), c = step.let("goDown", "c", c - 3);
                }
            }
        }
    }

    static constexpr std::string_view correctedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
a = 1,  b = 2
if x1 > x2  #swap
  a = 2,  b = 1
if x[a] > xmax or x[b] < xmin: reject  #besideX
col = 1,  X = xmax
if x[a] < xmin  #left
  col = 0,  X = xmin
row = 1
if y[a] < ymin  #below
  if y[b] < ymin: reject  #bothBelow
  row = 0
else if y[a] > ymax  #above
  if y[b] > ymax: reject  #bothAbove
  row = 2
c = 3*row + col  #cell
if c == 4 and x[b] <= xmax and y[b] >= ymin and y[b] <= ymax: accept  #inside
dx = x[b]-x[a],  dy = y[b]-y[a],  s = sign(dy)  #extent
if dx == 0 or s == 0  #straight
  hold both ends inside the window  #hold
  accept  #acceptStraight
up = s > 0  #up
yIn = up ? ymin : ymax,  yOut = up ? ymax : ymin  #sides
Y = row == 1 ? yOut : yIn  #Y
e = dy*(X-x[a]) + dx*(y[a]-Y)  #e
repeat
  if (e == 0 ? col == 0 : up ? e < 0 : e > 0)  #right
    if c == 1 or c == 7: reject  #missesRight
    else if c == 3  #fromLeft
      x[a] = xmin,  y[a] = held(yOut + e/dx)  #atLeft
      if x[b] <= xmax and (up ? y[b] <= yOut : y[b] >= yOut): accept  #endsLeft
    else if c == 4  #toRight
      x[b] = xmax,  y[b] = held(yOut + e/dx)  #atRight
      accept the line from x[1], y[1] to x[2], y[2]  #acceptRight
    e = e + dy*(xmax-xmin),  c = c+1,  col = 1  #goRight
  else
    if c == 3: reject  #missesAcross
    else if c == 1 or c == 7  #fromAcross
      x[a] = max(xmax - e/dy, xmin),  y[a] = yIn  #atEntry
      if x[b] <= xmax and (up ? y[b] <= yOut : y[b] >= yOut): accept  #endsAcross
    else if c == 4  #toAcross
      x[b] = max(xmax - e/dy, xmin),  y[b] = yOut  #atExit
      accept the line from x[1], y[1] to x[2], y[2]  #acceptAcross
    e = up ? e - dx*(ymax-ymin) : e + dx*(ymax-ymin)  #nextError
    c = up ? c+3 : c-3  #nextCell
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        return step.test("swap", s.a.x > s.b.x) ? fromEnd(1, s, w, step) : fromEnd(0, s, w, step);
    }

    static constexpr int signOf(auto order)
    {
        return std::is_lt(order) ? -1 : std::is_gt(order) ? 1 : 0;
    }

    /// Clips a segment whose End a (0: End 1, 1: End 2) is not further right than the other end.
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> fromEnd(int a, const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, Step& step)
    {
        const int b = 1 - a;
        step.set("a", a + 1), step.set("b", b + 1);
        const glm::vec<2, T>&from = a == 0 ? s.a : s.b, &to = a == 0 ? s.b : s.a;
        const auto cell = cellOf(from, to, w, step);
        if (!cell)
            return std::nullopt;
        const int c = step.let("cell", "c", 3 * cell->row + cell->col);
        if (step.test("inside", c == 4 && to.x <= w.max.x && to.y >= w.min.y && to.y <= w.max.y))
            return step.accept("inside", s);
        const T dx = step.set("dx", to.x - from.x), dy = to.y - from.y;
        const int sign = step.set("s", signOf(dy <=> T(0)));
        step.let("extent", "dy", dy);
        if (step.test("straight", dx == T(0) || sign == 0)) {
            const BasicSegment<T> visible{clamped(s.a, w), clamped(s.b, w)};
            step.left("hold", visible);
            return step.accept("acceptStraight", visible);
        }
        const Way<T> way{a, b, dx, dy, step.let("up", "up", sign > 0)};
        return walk(s, *cell, way, w, step);
    }

    /// A cell, and the x of its right side.
    template <class T>
    struct Cell {
        int col, row;
        T X;
    };

    /// The cell of End a, where the walk begins; nothing if both ends are found beyond one edge.
    template <class T, class Step>
    static constexpr std::optional<Cell<T>> cellOf(const glm::vec<2, T>& a, const glm::vec<2, T>& b,
                                                   const BasicWindow<T>& w, Step& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        if (step.test("besideX", a.x > xmax || b.x < xmin, Edge::Right, Edge::Left))
            return step.reject("besideX");
        const bool isLeft = step.test("left", a.x < xmin, Edge::Left);
        const int col = step.set("col", isLeft ? 0 : 1);
        const T X = step.set("X", isLeft ? xmin : xmax);
        int row = step.set("row", 1);
        if (step.test("below", a.y < ymin, Edge::Bottom)) {
            if (step.test("bothBelow", b.y < ymin, Edge::Bottom))
                return step.reject("bothBelow");
            row = step.set("row", 0);
        } else if (step.test("above", a.y > ymax, Edge::Top)) {
            if (step.test("bothAbove", b.y > ymax, Edge::Top))
                return step.reject("bothAbove");
            row = step.set("row", 2);
        }
        return Cell<T>{col, row, X};
    }

    /// The direction of the walk: from End a to End b (0: End 1, 1: End 2), and whether upwards.
    template <class T>
    struct Way {
        int a, b;
        T dx, dy;
        bool up;
    };

    /// The walk from cell to cell.
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): nested as in the pseudo-code
    static constexpr std::optional<BasicSegment<T>> walk(const BasicSegment<T>& s,
                                                         const Cell<T>& cell, const Way<T>& way,
                                                         const BasicWindow<T>& w, Step& step)
    {
        const auto& [a, b, dx, dy, upwards] = way;
        const bool up = upwards; // clang cannot capture a structured binding
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        BasicSegment<T> visible = s;
        glm::vec<2, T>&from = a == 0 ? visible.a : visible.b, &to = a == 0 ? visible.b : visible.a;
        const T yIn = step.set("yIn", up ? ymin : ymax);
        const T yOut = step.let("sides", "yOut", up ? ymax : ymin);
        const T Y = step.let("Y", "Y", cell.row == 1 ? yOut : yIn);
        T e = step.let("e", "e", dy * (cell.X - from.x) + dx * (from.y - Y));
        // On the opposite side no clamping is needed: by the sign of e, rounding cannot move a new
        // end out of the window there.
        const auto heldX = [&](T x) { return x < xmin ? xmin : x; };
        const auto heldY = [&](T y) { return (up ? y < yIn : y > yIn) ? yIn : y; };
        for (int col = cell.col, c = 3 * cell.row + col;;) {
            const auto sign = e <=> T(0);
            const bool right = std::is_eq(sign) ? col == 0
                               : up             ? std::is_lt(sign)
                                                : std::is_gt(sign);
            if (step.test("right", right, rightOf(c))) {
                if (step.test("missesRight", c == 1 || c == 7)) {
                    return step.reject("missesRight");
                } else if (step.test("fromLeft", c == 3)) {
                    from = {xmin, heldY(yOut + e / dx)};
                    step.cut("atLeft", a, from, Edge::Left);
                    if (step.test("endsLeft", to.x <= xmax && (up ? to.y <= yOut : to.y >= yOut)))
                        return step.accept("endsLeft", visible);
                } else if (step.test("toRight", c == 4)) {
                    to = {xmax, heldY(yOut + e / dx)};
                    step.cut("atRight", b, to, Edge::Right);
                    return step.accept("acceptRight", visible);
                }
                col = step.set("col", 1), e = step.set("e", e + dy * (xmax - xmin));
                c = step.let("goRight", "c", c + 1);
            } else {
                if (step.test("missesAcross", c == 3)) {
                    return step.reject("missesAcross");
                } else if (step.test("fromAcross", c == 1 || c == 7)) {
                    from = {heldX(xmax - e / dy), yIn};
                    step.cut("atEntry", a, from, up ? Edge::Bottom : Edge::Top);
                    if (step.test("endsAcross", to.x <= xmax && (up ? to.y <= yOut : to.y >= yOut)))
                        return step.accept("endsAcross", visible);
                } else if (step.test("toAcross", c == 4)) {
                    to = {heldX(xmax - e / dy), yOut};
                    step.cut("atExit", b, to, up ? Edge::Top : Edge::Bottom);
                    return step.accept("acceptAcross", visible);
                }
                e = step.let("nextError", "e",
                             up ? e - dx * (ymax - ymin) : e + dx * (ymax - ymin));
                c = step.let("nextCell", "c", up ? c + 3 : c - 3);
            }
        }
    }
};

template Algorithm describe<SlaterBarsky>();

} // namespace clipping
