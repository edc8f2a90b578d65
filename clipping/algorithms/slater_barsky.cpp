// SPDX-License-Identifier: MIT
//
// Slater-Barsky (1994).
//
//   M. Slater, B. A. Barsky: 2D Line and Polygon Clipping Based on Space Subdivision.
//   The Visual Computer 10, 1994, 407-422.
//
// Published: the function CLIPLINE of the program EnergyPlus, which implements the paper; only
// parts of the paper itself were available. CLIPLINE repeats the first lines for each cell, and
// tests line 22 once for the whole walk. Where line 52 has c <= 3, CLIPLINE tests c == 3 and loops
// forever if y2 is NaN. Corrected: the ends of an axis-parallel segment are clamped to the window,
// so that there is no division by 0; a tie at a corner goes towards the window; the sign of dy is
// tested once; a new end is clamped to the window on the side where rounding may have left it
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
if x1 > x2
  a = 2,  b = 1
if x[a] > xmax or x[b] < xmin: reject
col = 1,  X = xmax
if x[a] < xmin
  col = 0,  X = xmin
row = 1
if y[a] < ymin
  if y[b] < ymin: reject
  row = 0
else if y[a] > ymax
  if y[b] > ymax: reject
  row = 2
c = 3*row + col
if c == 4 and x[b] <= xmax and y[b] >= ymin and y[b] <= ymax: accept
dx = x[b]-x[a],  dy = y[b]-y[a]
Y = row == 0 ? ymin : row == 2 or dy > 0 ? ymax : ymin
e = dy*(X-x[a]) + dx*(y[a]-Y)
repeat
  if dy > 0
    if e < 0
      if c == 1: reject
      else if c == 3
        x[a] = xmin,  y[a] = ymax + e/dx
        if x[b] <= xmax and y[b] <= ymax: accept
      else if c == 4
        x[b] = xmax,  y[b] = ymax + e/dx
        accept the line from x[1], y[1] to x[2], y[2]
      e = e + dy*(xmax-xmin),  c = c+1
    else
      if c == 3: reject
      else if c == 1
        x[a] = xmax - e/dy,  y[a] = ymin
        if x[b] <= xmax and y[b] <= ymax: accept
      else if c == 4
        x[b] = xmax - e/dy,  y[b] = ymax
        accept the line from x[1], y[1] to x[2], y[2]
      e = e - dx*(ymax-ymin),  c = c+3
  else
    if e >= 0
      if c == 7: reject
      else if c == 3
        x[a] = xmin,  y[a] = ymin + e/dx
        if x[b] <= xmax and y[b] >= ymin: accept
      else if c == 4
        x[b] = xmax,  y[b] = ymin + e/dx
        accept the line from x[1], y[1] to x[2], y[2]
      e = e + dy*(xmax-xmin),  c = c+1
    else
      if c <= 3: reject
      else if c == 7
        x[a] = xmax - e/dy,  y[a] = ymax
        if x[b] <= xmax and y[b] >= ymin: accept
      else if c == 4
        x[b] = xmax - e/dy,  y[b] = ymin
        accept the line from x[1], y[1] to x[2], y[2]
      e = e + dx*(ymax-ymin),  c = c-3
)";
    template <class T, class Step>
    // NOLINTNEXTLINE(readability-function-size): one function, as EnergyPlus has it
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        const T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const bool swapped = step.test(3, x1 > x2);
        const int a = swapped ? 1 : 0, b = swapped ? 0 : 1;
        step.set("a", a + 1), step.set("b", b + 1);
        // x[a], y[a], x[b], y[b]: an array indexed by a would cost a fifth of the time.
        T xa = swapped ? x2 : x1, ya = swapped ? y2 : y1;
        T xb = swapped ? x1 : x2, yb = swapped ? y1 : y2;
        if (step.test(5, xa > xmax || xb < xmin, Edge::Right, Edge::Left))
            return step.reject(5);
        const bool isLeft = step.test(7, xa < xmin, Edge::Left);
        const int col = step.set("col", isLeft ? 0 : 1);
        const T X = step.set("X", isLeft ? xmin : xmax);
        int row = step.set("row", 1);
        if (step.test(10, ya < ymin, Edge::Bottom)) {
            if (step.test(11, yb < ymin, Edge::Bottom))
                return step.reject(11);
            row = step.set("row", 0);
        } else if (step.test(13, ya > ymax, Edge::Top)) {
            if (step.test(14, yb > ymax, Edge::Top))
                return step.reject(14);
            row = step.set("row", 2);
        }
        int c = step.let(16, "c", 3 * row + col);
        if (step.test(17, c == 4 && xb <= xmax && yb >= ymin && yb <= ymax))
            return step.accept(17, s);
        const T dx = step.set("dx", xb - xa), dy = step.let(18, "dy", yb - ya);
        const T Y = step.let(19, "Y", row == 0 ? ymin : row == 2 || dy > T(0) ? ymax : ymin);
        T e = step.let(20, "e", dy * (X - xa) + dx * (ya - Y));
        const auto visible = [&] {
            return swapped ? BasicSegment<T>{{xb, yb}, {xa, ya}}
                           : BasicSegment<T>{{xa, ya}, {xb, yb}};
        };
        for (;;) {
            if (step.test(22, dy > T(0))) {
                if (step.test(23, e < T(0), rightOf(c))) {
                    if (step.test(24, c == 1)) {
                        return step.reject(24);
                    } else if (step.test(25, c == 3)) {
                        xa = xmin, ya = ymax + e / dx;
                        step.cut(26, a, xa, ya, Edge::Left);
                        if (step.test(27, xb <= xmax && yb <= ymax))
                            return step.accept(27, visible());
                    } else if (step.test(28, c == 4)) {
                        xb = xmax, yb = ymax + e / dx;
                        step.cut(29, b, xb, yb, Edge::Right);
                        return step.accept(30, visible());
                    }
                    e = step.set("e", e + dy * (xmax - xmin)), c = step.let(31, "c", c + 1);
                } else {
                    if (step.test(33, c == 3)) {
                        return step.reject(33);
                    } else if (step.test(34, c == 1)) {
                        xa = xmax - e / dy, ya = ymin;
                        step.cut(35, a, xa, ya, Edge::Bottom);
                        if (step.test(36, xb <= xmax && yb <= ymax))
                            return step.accept(36, visible());
                    } else if (step.test(37, c == 4)) {
                        xb = xmax - e / dy, yb = ymax;
                        step.cut(38, b, xb, yb, Edge::Top);
                        return step.accept(39, visible());
                    }
                    e = step.set("e", e - dx * (ymax - ymin)), c = step.let(40, "c", c + 3);
                }
            } else {
                if (step.test(42, e >= T(0), rightOf(c))) {
                    if (step.test(43, c == 7)) {
                        return step.reject(43);
                    } else if (step.test(44, c == 3)) {
                        xa = xmin, ya = ymin + e / dx;
                        step.cut(45, a, xa, ya, Edge::Left);
                        if (step.test(46, xb <= xmax && yb >= ymin))
                            return step.accept(46, visible());
                    } else if (step.test(47, c == 4)) {
                        xb = xmax, yb = ymin + e / dx;
                        step.cut(48, b, xb, yb, Edge::Right);
                        return step.accept(49, visible());
                    }
                    e = step.set("e", e + dy * (xmax - xmin)), c = step.let(50, "c", c + 1);
                } else {
                    if (step.test(52, c <= 3)) {
                        return step.reject(52);
                    } else if (step.test(53, c == 7)) {
                        xa = xmax - e / dy, ya = ymax;
                        step.cut(54, a, xa, ya, Edge::Top);
                        if (step.test(55, xb <= xmax && yb >= ymin))
                            return step.accept(55, visible());
                    } else if (step.test(56, c == 4)) {
                        xb = xmax - e / dy, yb = ymin;
                        step.cut(57, b, xb, yb, Edge::Bottom);
                        return step.accept(58, visible());
                    }
                    e = step.set("e", e + dx * (ymax - ymin)), c = step.let(59, "c", c - 3);
                }
            }
        }
    }

    static constexpr std::string_view correctedCode = R"(
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
a = 1,  b = 2
if x1 > x2
  a = 2,  b = 1
if x[a] > xmax or x[b] < xmin: reject
col = 1,  X = xmax
if x[a] < xmin
  col = 0,  X = xmin
row = 1
if y[a] < ymin
  if y[b] < ymin: reject
  row = 0
else if y[a] > ymax
  if y[b] > ymax: reject
  row = 2
c = 3*row + col
if c == 4 and x[b] <= xmax and y[b] >= ymin and y[b] <= ymax: accept
dx = x[b]-x[a],  dy = y[b]-y[a],  s = sign(dy)
if dx == 0 or s == 0
  hold both ends inside the window
  accept
up = s > 0
yIn = up ? ymin : ymax,  yOut = up ? ymax : ymin
Y = row == 1 ? yOut : yIn
e = dy*(X-x[a]) + dx*(y[a]-Y)
repeat
  if (e == 0 ? col == 0 : up ? e < 0 : e > 0)
    if c == 1 or c == 7: reject
    else if c == 3
      x[a] = xmin,  y[a] = held(yOut + e/dx)
      if x[b] <= xmax and (up ? y[b] <= yOut : y[b] >= yOut): accept
    else if c == 4
      x[b] = xmax,  y[b] = held(yOut + e/dx)
      accept the line from x[1], y[1] to x[2], y[2]
    e = e + dy*(xmax-xmin),  c = c+1,  col = 1
  else
    if c == 3: reject
    else if c == 1 or c == 7
      x[a] = held(xmax - e/dy),  y[a] = yIn
      if x[b] <= xmax and (up ? y[b] <= yOut : y[b] >= yOut): accept
    else if c == 4
      x[b] = held(xmax - e/dy),  y[b] = yOut
      accept the line from x[1], y[1] to x[2], y[2]
    e = up ? e - dx*(ymax-ymin) : e + dx*(ymax-ymin)
    c = up ? c+3 : c-3
)";
    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        return step.test(3, s.a.x > s.b.x) ? fromEnd(1, s, w, step) : fromEnd(0, s, w, step);
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
        const int c = step.let(16, "c", 3 * cell->row + cell->col);
        if (step.test(17, c == 4 && to.x <= w.max.x && to.y >= w.min.y && to.y <= w.max.y))
            return step.accept(17, s);
        const T dx = step.set("dx", to.x - from.x), dy = to.y - from.y;
        const int sign = step.set("s", signOf(dy <=> T(0)));
        step.let(18, "dy", dy);
        if (step.test(19, dx == T(0) || sign == 0)) {
            const BasicSegment<T> visible{clamped(s.a, w), clamped(s.b, w)};
            step.left(20, visible);
            return step.accept(21, visible);
        }
        const Way<T> way{a, b, dx, dy, step.let(22, "up", sign > 0)};
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
        if (step.test(5, a.x > xmax || b.x < xmin, Edge::Right, Edge::Left))
            return step.reject(5);
        const bool isLeft = step.test(7, a.x < xmin, Edge::Left);
        const int col = step.set("col", isLeft ? 0 : 1);
        const T X = step.set("X", isLeft ? xmin : xmax);
        int row = step.set("row", 1);
        if (step.test(10, a.y < ymin, Edge::Bottom)) {
            if (step.test(11, b.y < ymin, Edge::Bottom))
                return step.reject(11);
            row = step.set("row", 0);
        } else if (step.test(13, a.y > ymax, Edge::Top)) {
            if (step.test(14, b.y > ymax, Edge::Top))
                return step.reject(14);
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

    /// Lines 23 to 45: the walk from cell to cell.
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
        const T yOut = step.let(23, "yOut", up ? ymax : ymin);
        const T Y = step.let(24, "Y", cell.row == 1 ? yOut : yIn);
        T e = step.let(25, "e", dy * (cell.X - from.x) + dx * (from.y - Y));
        // On the opposite side no clamping is needed: by the sign of e, rounding cannot move a new
        // end out of the window there.
        const auto heldX = [&](T x) { return x < xmin ? xmin : x; };
        const auto heldY = [&](T y) { return (up ? y < yIn : y > yIn) ? yIn : y; };
        for (int col = cell.col, c = 3 * cell.row + col;;) {
            const auto sign = e <=> T(0);
            const bool right = std::is_eq(sign) ? col == 0
                               : up             ? std::is_lt(sign)
                                                : std::is_gt(sign);
            if (step.test(27, right, rightOf(c))) {
                if (step.test(28, c == 1 || c == 7)) {
                    return step.reject(28);
                } else if (step.test(29, c == 3)) {
                    from = {xmin, heldY(yOut + e / dx)};
                    step.cut(30, a, from, Edge::Left);
                    if (step.test(31, to.x <= xmax && (up ? to.y <= yOut : to.y >= yOut)))
                        return step.accept(31, visible);
                } else if (step.test(32, c == 4)) {
                    to = {xmax, heldY(yOut + e / dx)};
                    step.cut(33, b, to, Edge::Right);
                    return step.accept(34, visible);
                }
                col = step.set("col", 1), e = step.set("e", e + dy * (xmax - xmin));
                c = step.let(35, "c", c + 1);
            } else {
                if (step.test(37, c == 3)) {
                    return step.reject(37);
                } else if (step.test(38, c == 1 || c == 7)) {
                    from = {heldX(xmax - e / dy), yIn};
                    step.cut(39, a, from, up ? Edge::Bottom : Edge::Top);
                    if (step.test(40, to.x <= xmax && (up ? to.y <= yOut : to.y >= yOut)))
                        return step.accept(40, visible);
                } else if (step.test(41, c == 4)) {
                    to = {heldX(xmax - e / dy), yOut};
                    step.cut(42, b, to, up ? Edge::Top : Edge::Bottom);
                    return step.accept(43, visible);
                }
                e = step.let(44, "e", up ? e - dx * (ymax - ymin) : e + dx * (ymax - ymin));
                c = step.let(45, "c", up ? c + 3 : c - 3);
            }
        }
    }
};

template Algorithm describe<SlaterBarsky>();

} // namespace clipping
