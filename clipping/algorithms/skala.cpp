// SPDX-License-Identifier: MIT
//
// Skala (2005).
//
//   V. Skala: A New Approach to Line and Line Segment Clipping in Homogeneous Coordinates.
//   The Visual Computer 21(11), 2005, 905-914.
//
// Published: the paper's algorithm for segments; it returns the two crossings in the order of the
// table, after the homogeneous division. Corrected: the origin is End 1, so that the line has no
// third coefficient that could lose digits. If the whole window seems to be on the line's left or
// on the line, the test is repeated with "strictly left". The table distinguishes the edge of entry
// from that of exit, so that the ends keep their order. A new end takes the coordinate of its edge
// and is clamped to the window.

#include "clipping/algorithms/skala.h"

#include "clipping/algorithms/lines_and_rays/uses.h"
#include "clipping/describe.h"
#include "clipping/fixed_text.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"
#include "clipping/part.h"
#include "clipping/polygon/uses.h"

namespace clipping {

namespace {

constexpr std::string_view digits = "0123";
/// The bits of edges 0 to 3 in an outcode.
constexpr std::array cornerBits{outcode::bottom, outcode::right, outcode::top, outcode::left};

/// Whether a pattern of corners can occur and crosses the window.
constexpr bool isRow(std::size_t c) { return passages[c].enter != passages[c].leave; }

/// "TAB1[0110] = 2", an entry of the tables at the end of the pseudo-code.
constexpr void addEntry(auto& text, std::string_view table, std::size_t c, std::string_view value,
                        std::string_view end)
{
    text.add(table), text.add("[");
    for (std::size_t bit = 8; bit > 0; bit /= 2)
        text.add((c & bit) != 0 ? "1" : "0");
    text.add("] = "), text.add(value), text.add(end);
}

} // namespace

struct Skala {
    static constexpr About about{
        .key = "skala",
        .abbreviation = "Skala",
        .name = "Skala",
        .year = 2005,
        .idea = "Determine on which side of the line each corner of the window lies; the pattern "
                "gives the two edges that the line crosses.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr const auto* polygon = &skalaPolygon;
    static constexpr const auto* polygonBySearch = &skalaSearchedPolygon;
    static constexpr auto line = &skalaLine;
    static constexpr auto ray = &skalaRay;

    static constexpr std::string_view publishedSteps = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
if code1 | code2 == 0000  #inside
  accept the line from x1, y1 to x2, y2  #acceptWhole
if code1 & code2 != 0000  #beyond
  reject  #rejectBeyond
px = y1-y2,  py = x2-x1,  pw = x1*y2 - x2*y1  #line
for k = 0, 1, 2, 3
  F = px*X[k] + py*Y[k] + pw  #F
  c[k] = F >= 0 ? 1 : 0  #corner
c = c[0] + 2*c[1] + 4*c[2] + 8*c[3]  #pattern
if c == 0000 or c == 1111  #missed
  reject  #reject
i = TAB1[c],  j = TAB2[c]  #edges
if code1 != 0000 and code2 != 0000  #bothOutside
  meet(i)  #meetFirst
  x1 = x/w,  y1 = y/w  #moveFirst
  meet(j)  #meetSecond
  x2 = x/w,  y2 = y/w  #moveSecond
else if code1 == 0000  #onlyEnd2
  if code2 & MASK[c] != 0000: meet(i)  #masked2
  else: meet(j)  #unmasked2
  x2 = x/w,  y2 = y/w  #move2
else
  if code1 & MASK[c] != 0000: meet(i)  #masked1
  else: meet(j)  #unmasked1
  x1 = x/w,  y1 = y/w  #move1
accept the line from x1, y1 to x2, y2  #accept
meet(n):
  x = py*ew[n] - pw*ey[n]  #x
  y = pw*ex[n] - px*ew[n]  #y
  w = px*ey[n] - py*ex[n]  #w
ex[0] = 0,  ey[0] = 1,  ew[0] = -ymin  #edge0
ex[1] = 1,  ey[1] = 0,  ew[1] = -xmax  #edge1
ex[2] = 0,  ey[2] = 1,  ew[2] = -ymax  #edge2
ex[3] = 1,  ey[3] = 0,  ew[3] = -xmin  #edge3
X[0] = xmin,  Y[0] = ymin
X[1] = xmax,  Y[1] = ymin
X[2] = xmax,  Y[2] = ymax
X[3] = xmin,  Y[3] = ymax
)";
    /// A point or a line in homogeneous coordinates: x*x' + y*y' + w*w' is 0 where they meet.
    template <class T>
    struct Homogeneous {
        T x, y, w;
    };

    /// The paper's table: of the edges that a line crosses, the first in its order, the other, and
    /// the first one's bit in an outcode.
    static constexpr auto TAB1 = [] {
        std::array<int, 16> first{};
        for (std::size_t c = 0; c < 16; ++c)
            first[c] =
                passages[c].enter < passages[c].leave ? passages[c].enter : passages[c].leave;
        return first;
    }();
    static constexpr auto TAB2 = [] {
        std::array<int, 16> second{};
        for (std::size_t c = 0; c < 16; ++c)
            second[c] = passages[c].enter + passages[c].leave - TAB1[c];
        return second;
    }();
    static constexpr auto MASK = [] {
        std::array<unsigned, 16> mask{};
        for (std::size_t c = 0; c < 16; ++c)
            mask[c] = isRow(c) ? cornerBits[std::size_t(TAB1[c])] : 0;
        return mask;
    }();
    static constexpr auto publishedText = [] {
        constexpr std::array names{"BOTTOM", "RIGHT", "TOP", "LEFT"};
        FixedText<publishedSteps.size() + 12 * 60> text;
        text.add(publishedSteps);
        for (std::size_t c = 0; c < 16; ++c)
            if (isRow(c)) {
                addEntry(text, "TAB1", c, digits.substr(std::size_t(TAB1[c]), 1), ",  ");
                addEntry(text, "TAB2", c, digits.substr(std::size_t(TAB2[c]), 1), ",  ");
                addEntry(text, "MASK", c, names[std::size_t(TAB1[c])], "\n");
            }
        return text;
    }();
    static constexpr std::string_view publishedCode = publishedText.view();

    /// The pseudo-code's names of the corners' bits.
    static constexpr std::array bits{"c[0]", "c[1]", "c[2]", "c[3]"};
    /// The labels of the edges' vectors.
    static constexpr std::array edges{"edge0", "edge1", "edge2", "edge3"};

    /// The cross product of the line p and edge n. `call` is the label of the call.
    template <class T, class Step>
    static constexpr Homogeneous<T> meet(std::string_view call, int n, const Homogeneous<T>& p,
                                         const BasicWindow<T>& window, Step& step)
    {
        const Edge edge = edgesFromCorners[n];
        step.let(call, "n", n, edge);
        const auto& [px, py, pw] = p;
        const auto [ex, ey, ew] = n == 0   ? Homogeneous<T>{T(0), T(1), -window.min.y}
                                  : n == 1 ? Homogeneous<T>{T(1), T(0), -window.max.x}
                                  : n == 2 ? Homogeneous<T>{T(0), T(1), -window.max.y}
                                           : Homogeneous<T>{T(1), T(0), -window.min.x};
        step.set("ex[n]", ex), step.set("ey[n]", ey), step.let(edges[n], "ew[n]", ew, edge);
        return {step.let("x", "x", py * ew - pw * ey, edge),
                step.let("y", "y", pw * ex - px * ew, edge),
                step.let("w", "w", px * ey - py * ex, edge)};
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>>
    published(const BasicSegment<T>& s, const BasicWindow<T>& window, Step&& step)
    {
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const auto& [min, max] = window;
        const std::array X{min.x, max.x, max.x, min.x}, Y{min.y, min.y, max.y, max.y};
        const unsigned code1 = step.set("code1", outcodeOf(s.a, window));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, window));
        if (step.test("inside", (code1 | code2) == 0))
            return step.accept("acceptWhole", s);
        if (step.test("beyond", (code1 & code2) != 0))
            return step.reject("rejectBeyond");
        const T px = step.set("px", y1 - y2), py = step.set("py", x2 - x1);
        const T pw = step.let("line", "pw", x1 * y2 - x2 * y1);
        unsigned c = 0;
        for (int k = 0; k < 4; ++k) {
            step.set("k", k), step.set("X[k]", X[k]), step.set("Y[k]", Y[k]);
            const T F = step.let("F", "F", px * X[k] + py * Y[k] + pw);
            c |= unsigned(step.let("corner", bits[k], F >= T(0) ? 1 : 0)) << k;
        }
        step.let("pattern", "c", c);
        if (step.test("missed", c == 0b0000 || c == 0b1111))
            return step.reject("reject");
        step.set("TAB1[c]", TAB1[c]), step.set("TAB2[c]", TAB2[c]), step.set("MASK[c]", MASK[c]);
        const int i = step.set("i", TAB1[c]), j = step.let("edges", "j", TAB2[c]);
        const Homogeneous<T> p{px, py, pw};
        if (step.test("bothOutside", code1 != 0 && code2 != 0)) {
            const auto [xi, yi, wi] = meet("meetFirst", i, p, window, step);
            x1 = xi / wi, y1 = yi / wi, step.cut("moveFirst", 0, x1, y1, "w");
            const auto [xj, yj, wj] = meet("meetSecond", j, p, window, step);
            x2 = xj / wj, y2 = yj / wj, step.cut("moveSecond", 1, x2, y2, "w");
        } else if (step.test("onlyEnd2", code1 == 0)) {
            const auto [x, y, w] = step.test("masked2", (code2 & MASK[c]) != 0, edgesFromCorners[i])
                                       ? meet("masked2", i, p, window, step)
                                       : meet("unmasked2", j, p, window, step);
            x2 = x / w, y2 = y / w, step.cut("move2", 1, x2, y2, "w");
        } else {
            const auto [x, y, w] = step.test("masked1", (code1 & MASK[c]) != 0, edgesFromCorners[i])
                                       ? meet("masked1", i, p, window, step)
                                       : meet("unmasked1", j, p, window, step);
            x1 = x / w, y1 = y / w, step.cut("move1", 0, x1, y1, "w");
        }
        return step.accept("accept", BasicSegment<T>{{x1, y1}, {x2, y2}});
    }

    // held(v) is v clamped to the window's range on its axis.
    static constexpr std::string_view correctedSteps = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
if code1 | code2 == 0000  #inside
  accept the line from x1, y1 to x2, y2  #acceptWhole
if code1 & code2 != 0000  #beyond
  reject  #rejectBeyond
dx = x2-x1,  dy = y2-y1  #line
f[0] = dx*(ymin-y1),  f[1] = dy*(xmax-x1)  #f01
f[2] = dx*(ymax-y1),  f[3] = dy*(xmin-x1)  #f23
c[0] = f[0] >= f[3] ? 1 : 0  #c0
c[1] = f[0] >= f[1] ? 1 : 0  #c1
c[2] = f[2] >= f[1] ? 1 : 0  #c2
c[3] = f[2] >= f[3] ? 1 : 0  #c3
c = c[0] + 2*c[1] + 4*c[2] + 8*c[3]  #pattern
if c == 1111  #allLeft
  c[0] = f[0] > f[3] ? 1 : 0  #strict0
  c[1] = f[0] > f[1] ? 1 : 0  #strict1
  c[2] = f[2] > f[1] ? 1 : 0  #strict2
  c[3] = f[2] > f[3] ? 1 : 0  #strict3
  c = c[0] + 2*c[1] + 4*c[2] + 8*c[3]  #strictPattern
  if c == 0000  #flat
    c = dx > 0 ? 1100 : dx < 0 ? 0011 : dy > 0 ? 1001 : 0110  #flatPattern
if c == 0000 or c == 1111  #missed
  reject  #reject
i = enter[c],  j = leave[c]  #edges
if code2 != 0000  #end2
  if j == 1 or j == 3: x2 = ex[j],  y2 = held(y1 + f[j]/dx)  #upright2
  else: x2 = held(x1 + f[j]/dy),  y2 = ey[j]  #level2
if code1 != 0000  #end1
  if i == 1 or i == 3: x1 = ex[i],  y1 = held(y1 + f[i]/dx)  #upright1
  else: x1 = held(x1 + f[i]/dy),  y1 = ey[i]  #level1
accept the line from x1, y1 to x2, y2  #accept
ey[0] = ymin,  ex[1] = xmax,  ey[2] = ymax,  ex[3] = xmin
)";
    static constexpr auto correctedText = [] {
        FixedText<correctedSteps.size() + 12 * 40> text;
        text.add(correctedSteps);
        for (std::size_t c = 0; c < 16; ++c)
            if (isRow(c)) {
                const auto [enter, leave] = passages[c];
                addEntry(text, "enter", c, digits.substr(std::size_t(enter), 1), ",  ");
                addEntry(text, "leave", c, digits.substr(std::size_t(leave), 1), "\n");
            }
        return text;
    }();
    static constexpr std::string_view correctedCode = correctedText.view();

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, w));
        if (step.test("inside", (code1 | code2) == 0))
            return step.accept("acceptWhole", s);
        if (step.test("beyond", (code1 & code2) != 0))
            return step.reject("rejectBeyond");
        const auto crossing = crossingOf(s, w, step);
        if (!crossing)
            return std::nullopt;
        BasicSegment<T> visible = s;
        if (step.test("end2", code2 != 0)) {
            visible.b = crossedAt(crossing->j, *crossing, s.a, w);
            const Edge edge = edgesFromCorners[crossing->j];
            step.set(axisOf(edge) == 0 ? "ex[j]" : "ey[j]", levelOf(edge, w));
            step.cut(labelAt(edge, "upright2", "level2"), 1, visible.b, edge);
        }
        if (step.test("end1", code1 != 0)) {
            visible.a = crossedAt(crossing->i, *crossing, s.a, w);
            const Edge edge = edgesFromCorners[crossing->i];
            step.set(axisOf(edge) == 0 ? "ex[i]" : "ey[i]", levelOf(edge, w));
            step.cut(labelAt(edge, "upright1", "level1"), 0, visible.a, edge);
        }
        return step.accept("accept", visible);
    }
};

template Algorithm describe<Skala>();

} // namespace clipping
