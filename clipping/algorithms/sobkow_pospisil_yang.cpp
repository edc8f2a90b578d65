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

    static constexpr LabelsOfEdges cuts{"toLeft", "toRight", "toBottom", "toTop"};
    static constexpr LabelsOfEdges rejects{"notLeft", "notRight", "notBottom", "notTop"};
    static constexpr LabelsOfEdges tests{"ifLeft", "ifRight", "ifBottom", "ifTop"};
    static constexpr LabelsOfEdges ways{"wayToLeft", "wayToRight", "wayToBottom", "wayToTop"};
    static constexpr LabelsOfEdges lows{"lowAtLeft", "lowAtRight", "lowAtBottom", "lowAtTop"};
    static constexpr LabelsOfEdges highs{"highAtLeft", "highAtRight", "highAtBottom", "highAtTop"};

    static constexpr std::string_view publishedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
code = 16 * code1 + code2  #code
if code1 & code2 != 0000  #beyond
  reject  #reject
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
for each instruction of the script of this code
  if P: i = 1,  k = 2
  if Q: i = 2,  k = 1
accept the line from x[1], y[1] to x[2], y[2]  #accept
L(): y[i] = y[i] + (y[k]-y[i]) * (xmin-x[i]) / (x[k]-x[i]),  x[i] = xmin  #toLeft
R(): y[i] = y[i] + (y[k]-y[i]) * (xmax-x[i]) / (x[k]-x[i]),  x[i] = xmax  #toRight
B(): x[i] = x[i] + (x[k]-x[i]) * (ymin-y[i]) / (y[k]-y[i]),  y[i] = ymin  #toBottom
T(): x[i] = x[i] + (x[k]-x[i]) * (ymax-y[i]) / (y[k]-y[i]),  y[i] = ymax  #toTop
notL(): if x[i] < xmin: reject  #notLeft
notR(): if x[i] > xmax: reject  #notRight
notB(): if y[i] < ymin: reject  #notBottom
notT(): if y[i] > ymax: reject  #notTop
ifL(): if x[i] < xmin: L()  #ifLeft
ifR(): if x[i] > xmax: R()  #ifRight
ifB(): if y[i] < ymin: B()  #ifBottom
ifT(): if y[i] > ymax: T()  #ifTop
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
                constexpr bool mayReject = what.kind == Kind::RejectIfBeyond;
                constexpr auto label = labelOf(edge, mayReject ? rejects : tests);
                const bool beyond = step.test(label,
                                              edge == Edge::Left     ? x[i] < xmin
                                              : edge == Edge::Right  ? x[i] > xmax
                                              : edge == Edge::Bottom ? y[i] < ymin
                                                                     : y[i] > ymax,
                                              edge);
                if (beyond && mayReject)
                    step.reject(label);
                if (!beyond || mayReject)
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
            step.cut(labelOf(edge, cuts), i, x[i], y[i], edge);
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
        return step.accept("accept",
                           BasicSegment<T>{{ends.x[0], ends.y[0]}, {ends.x[1], ends.y[1]}});
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        static_assert(rejectsByOutcodes());
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, w));
        const std::size_t code = step.let("code", "code", 16 * std::size_t(code1) + code2);
        if (step.test("beyond", (code1 & code2) != 0)) // the rejected cases of the table
            return step.reject("reject");
        return player<Form::Published, T, std::remove_reference_t<Step>>[code](s, w, step);
    }

    static constexpr std::string_view correctedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
code = 16 * code1 + code2  #code
if code1 & code2 != 0000  #beyond
  reject  #reject
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
if code != 0  #outside
  dx = x2-x1,  dy = y2-y1  #extent
for each instruction of the script of this code, its holdLow, holdHigh
  if P: i = 1,  xi = x1,  yi = y1
  if Q: i = 2,  xi = x2,  yi = y2
accept the line from x[1], y[1] to x[2], y[2]  #accept
L(): way[i] = dy * (xmin-xi) / dx,  y = yi + way[i]  #wayToLeft
  if holdLow: y = max(y, ymin)  #lowAtLeft
  if holdHigh: y = min(y, ymax)  #highAtLeft
  x[i] = xmin,  y[i] = y  #toLeft
R(): way[i] = dy * (xmax-xi) / dx,  y = yi + way[i]  #wayToRight
  if holdLow: y = max(y, ymin)  #lowAtRight
  if holdHigh: y = min(y, ymax)  #highAtRight
  x[i] = xmax,  y[i] = y  #toRight
B(): way[i] = dx * (ymin-yi) / dy,  x = xi + way[i]  #wayToBottom
  if holdLow: x = max(x, xmin)  #lowAtBottom
  if holdHigh: x = min(x, xmax)  #highAtBottom
  y[i] = ymin,  x[i] = x  #toBottom
T(): way[i] = dx * (ymax-yi) / dy,  x = xi + way[i]  #wayToTop
  if holdLow: x = max(x, xmin)  #lowAtTop
  if holdHigh: x = min(x, xmax)  #highAtTop
  y[i] = ymax,  x[i] = x  #toTop
notL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: reject  #notLeft
notR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: reject  #notRight
notB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: reject  #notBottom
notT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: reject  #notTop
ifL(): if x[i] < xmin or x[i] == xmin and way[i] < xmin-xi: L()  #ifLeft
ifR(): if x[i] > xmax or x[i] == xmax and way[i] > xmax-xi: R()  #ifRight
ifB(): if y[i] < ymin or y[i] == ymin and way[i] < ymin-yi: B()  #ifBottom
ifT(): if y[i] > ymax or y[i] == ymax and way[i] > ymax-yi: T()  #ifTop
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
            constexpr std::array names{"x", "y"}, wayNames{"way[1]", "way[2]"};
            constexpr int i = what.i;
            constexpr glm::length_t axis = axisOf(what.edge), across = 1 - axis;
            const glm::vec<2, T>& from = i == 0 ? s.a : s.b;
            const T to = levelOf(what.edge, w), low = w.min[across], high = w.max[across];
            step.set("holdLow", what.holdLow), step.set("holdHigh", what.holdHigh);
            way[i] = step.set(wayNames[i], d[across] * (to - from[axis]) / d[axis]);
            T y =
                step.let(labelOf(what.edge, ways), names[across], from[across] + way[i], what.edge);
            if constexpr (what.holdLow)
                y = step.let(labelOf(what.edge, lows), names[across], y < low ? low : y, what.edge);
            if constexpr (what.holdHigh)
                y = step.let(labelOf(what.edge, highs), names[across], y > high ? high : y,
                             what.edge);
            glm::vec<2, T>& p = i == 0 ? visible.a : visible.b;
            p[axis] = to, p[across] = y;
            step.cut(labelOf(what.edge, cuts), i, p, what.edge);
        }

        /// false: nothing is visible.
        template <Instruction what>
        constexpr bool follow()
        {
            const glm::vec<2, T>& from = what.i == 0 ? s.a : s.b;
            step.set("i", what.i + 1), step.set("xi", from.x), step.set("yi", from.y);
            if constexpr (what.kind != Kind::Move) {
                constexpr bool mayReject = what.kind == Kind::RejectIfBeyond;
                constexpr auto label = labelOf(what.edge, mayReject ? rejects : tests);
                const bool beyond = step.test(label, isBeyond<what>(), what.edge);
                if (beyond && mayReject)
                    step.reject(label);
                if (!beyond || mayReject)
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
        if (step.test("outside", 16 * script.code1 + script.code2 != 0))
            ends.d = {step.set("dx", s.b.x - s.a.x), step.let("extent", "dy", s.b.y - s.a.y)};
        if (!followAll<script>(ends))
            return std::nullopt;
        return step.accept("accept", ends.visible);
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> corrected(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        const unsigned code1 = step.set("code1", outcodeOf(s.a, w));
        const unsigned code2 = step.let("codes", "code2", outcodeOf(s.b, w));
        const std::size_t code = step.let("code", "code", 16 * std::size_t(code1) + code2);
        if (step.test("beyond", (code1 & code2) != 0))
            return step.reject("reject");
        return player<Form::Corrected, T, std::remove_reference_t<Step>>[code](s, w, step);
    }
};

template Algorithm describe<SobkowPospisilYang>();

} // namespace clipping
