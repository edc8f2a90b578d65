// SPDX-License-Identifier: MIT
//
// Sobkow-Pospisil-Yang (1987), "Fast Clipping".
//
//   M. S. Sobkow, P. Pospisil, Y.-H. Yang: A Fast Two-Dimensional Line Clipping Algorithm via Line
//   Encoding. Computers & Graphics 11(4), 1987, 459-467.
//
// The regions of both ends give one of 81 cases. Each case has a short script of procedures that
// move an end or test its position. The scripts are data: the compiler turns each one into a
// function without loops, which is selected by the code of the case, as in the authors' switch.
//
// Corrected: each move starts from the given end, not from a rounded one. If a moved end is rounded
// onto an edge, the distance moved decides whether the end is beyond this edge. New ends are
// clamped to the window, except at the sides where they cannot be outside.

#include "clipping/algorithms/sobkow_pospisil_yang.h"

#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"

#include <compare>

namespace clipping {

using namespace fast_clipping;

struct SobkowPospisilYang {
    static constexpr About about{
        .key = "sobkow-pospisil-yang",
        .abbreviation = "SPY",
        .name = "Sobkow-Pospisil-Yang",
        .year = 1987,
        .idea = "The regions of both ends select one of 81 short scripts, which has only the cuts "
                "and tests that the case needs.",
        .ulps = 24, // README.md, "How far off"
    };

    template <Form form, auto script, class T, class Step>
    static constexpr auto playerOf()
    {
        if constexpr (form == Form::Published)
            return &playPublished<script, T, Step>;
        else
            return &playCorrected<script, T, Step>;
    }
    /// The function for every pair of outcodes, at index 16 * End 1's + End 2's; null where the
    /// table rejects.
    template <Form form, class T, class Step>
    static constexpr auto players()
    {
        using Player = std::optional<BasicSegment<T>> (*)(const BasicSegment<T>&,
                                                          const BasicWindow<T>&, Step&);
        std::array<Player, 256> all{};
        [&]<std::size_t... cases>(std::index_sequence<cases...>)
        {
            ((all[16 * regions[cases / 9] + regions[cases % 9]] =
                  scripts[cases / 9][cases % 9] == "x"
                      ? nullptr
                      : playerOf<form, scriptOf(cases / 9, cases % 9), T, Step>()),
             ...);
        }
        (std::make_index_sequence<81>{});
        return all;
    }
    template <Form form, class T, class Step>
    static constexpr auto player = players<form, T, Step>();

    /// The line of an edge, if the four edges have one line each, starting at `first`.
    static constexpr int lineOf(int first, Edge edge) { return first + static_cast<int>(edge) - 1; }

    static constexpr std::string_view publishedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)
code = 16 * code1 + code2
if code1 & code2 != 0000
  reject
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
for each instruction of the script of this code
  if P: i = 1,  k = 2
  if Q: i = 2,  k = 1
accept the line from x[1], y[1] to x[2], y[2]
L(): y[i] = y[i] + (y[k]-y[i]) * (xmin-x[i]) / (x[k]-x[i]),  x[i] = xmin
R(): y[i] = y[i] + (y[k]-y[i]) * (xmax-x[i]) / (x[k]-x[i]),  x[i] = xmax
B(): x[i] = x[i] + (x[k]-x[i]) * (ymin-y[i]) / (y[k]-y[i]),  y[i] = ymin
T(): x[i] = x[i] + (x[k]-x[i]) * (ymax-y[i]) / (y[k]-y[i]),  y[i] = ymax
notL(): if x[i] < xmin: reject
notR(): if x[i] > xmax: reject
notB(): if y[i] < ymin: reject
notT(): if y[i] > ymax: reject
ifL(): if x[i] < xmin: L()
ifR(): if x[i] > xmax: R()
ifB(): if y[i] < ymin: B()
ifT(): if y[i] > ymax: T()
)";
    /// The state of both ends while a script runs as published.
    template <class T, class Step>
    struct AsPublished {
        const BasicWindow<T>& w;
        Step& step;
        std::array<T, 2> x, y;

        /// false: nothing is visible.
        template <Instruction what>
        constexpr bool follow()
        {
            const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
            constexpr Edge edge = what.edge;
            constexpr int i = what.i, k = 1 - i;
            step.set("i", i + 1), step.set("k", k + 1);
            if constexpr (what.kind != Kind::Move) {
                constexpr bool rejects = what.kind == Kind::RejectIfBeyond;
                constexpr int line = lineOf(rejects ? 14 : 18, edge);
                const bool beyond = step.test(line,
                                              edge == Edge::Left     ? x[i] < xmin
                                              : edge == Edge::Right  ? x[i] > xmax
                                              : edge == Edge::Bottom ? y[i] < ymin
                                                                     : y[i] > ymax,
                                              edge);
                if (beyond && rejects)
                    step.reject(line);
                if (!beyond || rejects)
                    return !beyond;
            }
            if constexpr (edge == Edge::Left)
                y[i] = y[i] + (y[k] - y[i]) * (xmin - x[i]) / (x[k] - x[i]), x[i] = xmin;
            else if constexpr (edge == Edge::Right)
                y[i] = y[i] + (y[k] - y[i]) * (xmax - x[i]) / (x[k] - x[i]), x[i] = xmax;
            else if constexpr (edge == Edge::Bottom)
                x[i] = x[i] + (x[k] - x[i]) * (ymin - y[i]) / (y[k] - y[i]), y[i] = ymin;
            else
                x[i] = x[i] + (x[k] - x[i]) * (ymax - y[i]) / (y[k] - y[i]), y[i] = ymax;
            step.cut(lineOf(10, edge), i, x[i], y[i], edge);
            return true;
        }
    };

    template <auto script, class T, class Step>
    static constexpr std::optional<BasicSegment<T>>
    playPublished(const BasicSegment<T>& s, const BasicWindow<T>& w, Step& step)
    {
        AsPublished<T, Step> ends{w, step, {s.a.x, s.b.x}, {s.a.y, s.b.y}};
        if (!followAll<script>(ends))
            return std::nullopt;
        return step.accept(9, BasicSegment<T>{{ends.x[0], ends.y[0]}, {ends.x[1], ends.y[1]}});
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        static_assert(rejectsByOutcodes());
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let(1, "code2", outcodeOf(s.b, w));
        const std::size_t code = step.let(2, "code", 16 * std::size_t(code1) + code2);
        if (step.test(3, (code1 & code2) != 0)) // the rejected cases of the table
            return step.reject(4);
        return player<Form::Published, T, std::remove_reference_t<Step>>[code](s, w, step);
    }

    static constexpr std::string_view correctedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)
code = 16 * code1 + code2
if code1 & code2 != 0000
  reject
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if code != 0
  dx = x2-x1,  dy = y2-y1
for each instruction of the script of this code, its holdLow, holdHigh
  if P: i = 1,  xi = x1,  yi = y1
  if Q: i = 2,  xi = x2,  yi = y2
accept the line from x[1], y[1] to x[2], y[2]
L(): way[i] = dy * (xmin-xi) / dx,  y = yi + way[i]
  if holdLow: y = max(y, ymin)
  if holdHigh: y = min(y, ymax)
  x[i] = xmin,  y[i] = y
R(): way[i] = dy * (xmax-xi) / dx,  y = yi + way[i]
  if holdLow: y = max(y, ymin)
  if holdHigh: y = min(y, ymax)
  x[i] = xmax,  y[i] = y
B(): way[i] = dx * (ymin-yi) / dy,  x = xi + way[i]
  if holdLow: x = max(x, xmin)
  if holdHigh: x = min(x, xmax)
  y[i] = ymin,  x[i] = x
T(): way[i] = dx * (ymax-yi) / dy,  x = xi + way[i]
  if holdLow: x = max(x, xmin)
  if holdHigh: x = min(x, xmax)
  y[i] = ymax,  x[i] = x
notL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: reject
notR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: reject
notB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: reject
notT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: reject
ifL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: L()
ifR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: R()
ifB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: B()
ifT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: T()
)";
    /// The state of both ends while a script runs as corrected, with each end's distance moved
    /// along its edge.
    template <class T, class Step>
    struct AsCorrected {
        const BasicSegment<T>& s;
        const BasicWindow<T>& w;
        Step& step;
        BasicSegment<T> visible;
        glm::vec<2, T> d{}, way{};

        /// Whether an end that has moved is beyond an edge.
        template <Instruction what>
        constexpr bool isBeyond() const
        {
            constexpr glm::length_t axis = axisOf(what.edge);
            constexpr int i = what.i;
            const T from = (i == 0 ? s.a : s.b)[axis], level = levelOf(what.edge, w);
            const auto side = (i == 0 ? visible.a : visible.b)[axis] <=> level;
            if constexpr (isLow(what.edge))
                return std::is_lt(side) || (std::is_eq(side) && way[i] < level - from);
            else
                return std::is_gt(side) || (std::is_eq(side) && way[i] > level - from);
        }

        /// Moves an end to an edge.
        template <Instruction what>
        constexpr void move()
        {
            constexpr std::array names{"x", "y"}, ways{"way[1]", "way[2]"};
            constexpr int i = what.i, line = 8 + 4 * static_cast<int>(what.edge);
            constexpr glm::length_t axis = axisOf(what.edge), across = 1 - axis;
            const glm::vec<2, T>& from = i == 0 ? s.a : s.b;
            const T to = levelOf(what.edge, w), low = w.min[across], high = w.max[across];
            step.set("holdLow", what.holdLow), step.set("holdHigh", what.holdHigh);
            way[i] = step.set(ways[i], d[across] * (to - from[axis]) / d[axis]);
            T y = step.let(line, names[across], from[across] + way[i], what.edge);
            if constexpr (what.holdLow)
                y = step.let(line + 1, names[across], y < low ? low : y, what.edge);
            if constexpr (what.holdHigh)
                y = step.let(line + 2, names[across], y > high ? high : y, what.edge);
            glm::vec<2, T>& p = i == 0 ? visible.a : visible.b;
            p[axis] = to, p[across] = y;
            step.cut(line + 3, i, p, what.edge);
        }

        /// false: nothing is visible.
        template <Instruction what>
        constexpr bool follow()
        {
            const glm::vec<2, T>& from = what.i == 0 ? s.a : s.b;
            step.set("i", what.i + 1), step.set("xi", from.x), step.set("yi", from.y);
            if constexpr (what.kind != Kind::Move) {
                constexpr bool rejects = what.kind == Kind::RejectIfBeyond;
                constexpr int line = lineOf(rejects ? 28 : 32, what.edge);
                const bool beyond = step.test(line, isBeyond<what>(), what.edge);
                if (beyond && rejects)
                    step.reject(line);
                if (!beyond || rejects)
                    return !beyond;
            }
            move<what>();
            return true;
        }
    };

    template <auto script, class T, class Step>
    static constexpr std::optional<BasicSegment<T>>
    playCorrected(const BasicSegment<T>& s, const BasicWindow<T>& w, Step& step)
    {
        AsCorrected<T, Step> ends{s, w, step, s};
        if (step.test(6, 16 * script.code1 + script.code2 != 0))
            ends.d = {step.set("dx", s.b.x - s.a.x), step.let(7, "dy", s.b.y - s.a.y)};
        if (!followAll<script>(ends))
            return std::nullopt;
        return step.accept(11, ends.visible);
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let(1, "code2", outcodeOf(s.b, w));
        const std::size_t code = step.let(2, "code", 16 * std::size_t(code1) + code2);
        if (step.test(3, (code1 & code2) != 0))
            return step.reject(4);
        return player<Form::Corrected, T, std::remove_reference_t<Step>>[code](s, w, step);
    }
};

template Algorithm describe<SobkowPospisilYang>();

} // namespace clipping
