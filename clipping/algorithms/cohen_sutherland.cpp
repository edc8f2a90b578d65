// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland (1967), after D. Cohen and I. Sutherland's work on a flight simulator, in the
// form that J. Foley, A. van Dam, S. Feiner and J. Hughes print (Computer Graphics: Principles and
// Practice, 2nd edition, 1990, section 3.12).
//
// Published: that form, stopped after 64 cuts. It uses the outcode of a rounded point, which can
// clear one bit and set another forever. Corrected: an edge that has cut an end never cuts it
// again, so each end is cut at most four times; each cut starts from the given end; and the new
// outcode compares the distance moved with the distance to each edge, both of them accurate. In
// three dimensions there are six edges; Near and Far are the last two.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"

#include <array>

namespace clipping {

struct CohenSutherland {
    static constexpr About about{
        .key = "cohen-sutherland",
        .abbreviation = "CS",
        .name = "Cohen-Sutherland",
        .year = 1967,
        .idea = "Give each of the nine regions a code, and cut an outer end at one edge after "
                "another until the codes of both ends decide.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr int mostCuts = 64; // the cap of the published form

    /// The outcode bit of an edge.
    static constexpr unsigned bitOf(Edge edge) { return 1U << (static_cast<int>(edge) - 1); }

    static constexpr std::string_view publishedCode = R"(
code1 = outcode(x1, y1),  code2 = outcode(x2, y2)  #codes
repeat
  if code1 | code2 == 0000  #inside
    accept the line from x1, y1 to x2, y2  #accept
  if code1 & code2 != 0000  #beyond
    reject  #reject
  give up after 64 cuts  #giveUp
  codeOut = code1 != 0000 ? code1 : code2  #choose
  if codeOut & TOP != 0000  #top
    x = x1 + (x2-x1) * (ymax-y1) / (y2-y1),  y = ymax  #toTop
  else if codeOut & BOTTOM != 0000  #bottom
    x = x1 + (x2-x1) * (ymin-y1) / (y2-y1),  y = ymin  #toBottom
  else if codeOut & RIGHT != 0000  #right
    y = y1 + (y2-y1) * (xmax-x1) / (x2-x1),  x = xmax  #toRight
  else
    y = y1 + (y2-y1) * (xmin-x1) / (x2-x1),  x = xmin  #toLeft
  if codeOut == code1  #whose
    x1 = x,  y1 = y,  code1 = outcode(x1, y1)  #move1
  else
    x2 = x,  y2 = y,  code2 = outcode(x2, y2)  #move2
)";
    /// The edge at which an end with this outcode is cut.
    static constexpr Edge edgeToCut(unsigned code)
    {
        return code & outcode::top      ? Edge::Top
               : code & outcode::bottom ? Edge::Bottom
               : code & outcode::right  ? Edge::Right
                                        : Edge::Left;
    }

    template <class T, class Step>
    static constexpr std::optional<BasicSegment<T>> published(const BasicSegment<T>& s,
                                                              const BasicWindow<T>& w, Step&& step)
    {
        using namespace outcode;
        T x1 = s.a.x, y1 = s.a.y, x2 = s.b.x, y2 = s.b.y;
        const T xmin = w.min.x, ymin = w.min.y, xmax = w.max.x, ymax = w.max.y;
        const auto outcode = [&](T x, T y) { return outcodeOf(glm::vec<2, T>(x, y), w); };
        unsigned code1 = step.set("code1", outcode(x1, y1));
        unsigned code2 = step.let("codes", "code2", outcode(x2, y2));
        for (int cuts = 0;; ++cuts) {
            if (step.test("inside", (code1 | code2) == 0))
                return step.accept("accept", BasicSegment<T>{{x1, y1}, {x2, y2}});
            if (step.test("beyond", (code1 & code2) != 0))
                return step.reject("reject");
            if (cuts == mostCuts)
                return step.giveUp("giveUp");
            const unsigned codeOut = step.let("choose", "codeOut", code1 != 0 ? code1 : code2);
            T x, y;
            if (step.test("top", (codeOut & top) != 0, Edge::Top)) {
                x = step.set("x", x1 + (x2 - x1) * (ymax - y1) / (y2 - y1));
                y = step.let("toTop", "y", ymax, Edge::Top);
            } else if (step.test("bottom", (codeOut & bottom) != 0, Edge::Bottom)) {
                x = step.set("x", x1 + (x2 - x1) * (ymin - y1) / (y2 - y1));
                y = step.let("toBottom", "y", ymin, Edge::Bottom);
            } else if (step.test("right", (codeOut & right) != 0, Edge::Right)) {
                y = step.set("y", y1 + (y2 - y1) * (xmax - x1) / (x2 - x1));
                x = step.let("toRight", "x", xmax, Edge::Right);
            } else {
                y = step.set("y", y1 + (y2 - y1) * (xmin - x1) / (x2 - x1));
                x = step.let("toLeft", "x", xmin, Edge::Left);
            }
            if (step.test("whose", codeOut == code1)) {
                x1 = x, y1 = y, code1 = step.set("code1", outcode(x1, y1));
                step.cut("move1", 0, x1, y1, edgeToCut(codeOut));
            } else {
                x2 = x, y2 = y, code2 = step.set("code2", outcode(x2, y2));
                step.cut("move2", 1, x2, y2, edgeToCut(codeOut));
            }
        }
    }

    static constexpr std::string_view correctedCode = R"(
code[1] = outcode(x1, y1),  code[2] = outcode(x2, y2)  #codes
x[1] = x1,  y[1] = y1,  x[2] = x2,  y[2] = y2
done[1] = 0000,  done[2] = 0000
while code[1] | code[2] != 0000  #outside
  if code[1] & code[2] != 0000  #beyond
    reject  #reject
  if code[1] != 0000  #whose
    i = 1,  xi = x1,  yi = y1  #choose1
  else
    i = 2,  xi = x2,  yi = y2  #choose2
  if code[i] & TOP != 0000  #top
    run = (x2-x1) * (ymax-yi) / (y2-y1)  #wayToTop
    x[i] = xi + run,  y[i] = ymax,  done[i] = done[i] | TOP  #toTop
    code[i] = run < xmin-xi ? LEFT : run > xmax-xi ? RIGHT : 0000  #codeAtTop
  else if code[i] & BOTTOM != 0000  #bottom
    run = (x2-x1) * (ymin-yi) / (y2-y1)  #wayToBottom
    x[i] = xi + run,  y[i] = ymin,  done[i] = done[i] | BOTTOM  #toBottom
    code[i] = run < xmin-xi ? LEFT : run > xmax-xi ? RIGHT : 0000  #codeAtBottom
  else if code[i] & RIGHT != 0000  #right
    rise = (y2-y1) * (xmax-xi) / (x2-x1)  #wayToRight
    y[i] = yi + rise,  x[i] = xmax,  done[i] = done[i] | RIGHT  #toRight
    code[i] = rise < ymin-yi ? BOTTOM : rise > ymax-yi ? TOP : 0000  #codeAtRight
  else
    rise = (y2-y1) * (xmin-xi) / (x2-x1)  #wayToLeft
    y[i] = yi + rise,  x[i] = xmin,  done[i] = done[i] | LEFT  #toLeft
    code[i] = rise < ymin-yi ? BOTTOM : rise > ymax-yi ? TOP : 0000  #codeAtLeft
  code[i] = code[i] & ~done[i]  #undone
hold new ends inside the window  #hold
accept the line from x[1], y[1] to x[2], y[2]  #accept
)";
    /// An end that is moved to the window; i is 0 for a and 1 for b.
    template <class T, glm::length_t N>
    struct End {
        int i;
        const glm::vec<N, T>& given;
        unsigned code;
        unsigned done = 0;                ///< bits of the edges that have cut it
        glm::vec<N, T> at = given, way{}; ///< the current position, and the distance moved
        Edge edge = Edge::NoEdge;         ///< the edge that cut it last
    };

    static constexpr LabelsOfEdges tests{"", "right", "bottom", "top"};
    static constexpr LabelsOfEdges waysTo{"wayToLeft", "wayToRight", "wayToBottom", "wayToTop"};
    static constexpr LabelsOfEdges cuts{"toLeft", "toRight", "toBottom", "toTop"};
    static constexpr LabelsOfEdges codesAt{"codeAtLeft", "codeAtRight", "codeAtBottom",
                                           "codeAtTop"};

    /// Cuts an end at an edge, and tests which edges of the other axes it is beyond afterwards.
    template <Edge edge, class T, glm::length_t N, class Step>
    static constexpr void cutAt(End<T, N>& end, const BasicSegment<T, N>& s,
                                const BasicWindow<T, N>& w, Step& step)
    {
        constexpr std::array ways{"run", "rise", "way"};
        constexpr std::array codes{"code[1]", "code[2]"}, done{"done[1]", "done[2]"};
        constexpr glm::length_t axis = axisOf(edge);
        const T across = levelOf(edge, w) - end.given[axis], length = s.b[axis] - s.a[axis];
        for (glm::length_t k = 0; k < N; ++k)
            end.way[k] = k == axis ? across
                                   : step.let(labelOf(edge, waysTo), ways[k],
                                              (s.b[k] - s.a[k]) * across / length, edge);
        for (glm::length_t k = 0; k < N; ++k)
            end.at[k] = k == axis ? levelOf(edge, w) : end.given[k] + end.way[k];
        end.done = step.set(done[end.i], end.done | bitOf(edge)), end.edge = edge;
        step.cut(labelOf(edge, cuts), end.i, end.at, edge);
        end.code = 0;
        for (glm::length_t k = 0; k < N; ++k)
            if (k != axis)
                end.code |= end.way[k] < w.min[k] - end.given[k]   ? bitOf(lowerEdge(k))
                            : end.way[k] > w.max[k] - end.given[k] ? bitOf(upperEdge(k))
                                                                   : 0;
        end.code = step.let(labelOf(edge, codesAt), codes[end.i], end.code, edge);
        end.code = step.let("undone", codes[end.i], end.code & ~end.done);
    }

    /// Finds the edge at which to cut, in the order of the pseudo-code, and cuts there; in
    /// three dimensions Far and Near come first.
    template <Edge edge, class T, glm::length_t N, class Step>
    static constexpr void cut(End<T, N>& end, const BasicSegment<T, N>& s,
                              const BasicWindow<T, N>& w, Step& step)
    {
        if constexpr (edge != Edge::Left) // Left needs no test: no other edge remains
            if (!step.test(labelOf(edge, tests), (end.code & bitOf(edge)) != 0, edge))
                return cut<static_cast<Edge>(static_cast<int>(edge) - 1)>(end, s, w, step);
        cutAt<edge>(end, s, w, step);
    }

    /// Whether the first end has moved exactly as far along the segment as the edge of the second
    /// end. In three dimensions both ends are then the same point, but may be rounded differently.
    template <class T, glm::length_t N>
    static constexpr bool meet(const End<T, N>& one, const End<T, N>& two,
                               const BasicWindow<T, N>& w)
    {
        if (one.edge == Edge::NoEdge || two.edge == Edge::NoEdge)
            return false;
        const glm::length_t axis = axisOf(two.edge);
        return one.way[axis] == levelOf(two.edge, w) - one.given[axis];
    }

    template <class T, glm::length_t N, class Step>
    static constexpr std::optional<BasicSegment<T, N>>
    corrected(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w, Step&& step)
    {
        End<T, N> one{0, s.a, step.set("code[1]", outcodeOf(s.a, w))};
        End<T, N> two{1, s.b, step.let("codes", "code[2]", outcodeOf(s.b, w))};
        step.set("done[1]", one.done), step.set("done[2]", two.done);
        while (step.test("outside", (one.code | two.code) != 0)) {
            if (step.test("beyond", (one.code & two.code) != 0))
                return step.reject("reject");
            if (step.test("whose", one.code != 0)) {
                step.set("xi", s.a.x), step.set("yi", s.a.y), step.let("choose1", "i", 1);
                cut<upperEdge(N - 1)>(one, s, w, step);
            } else {
                step.set("xi", s.b.x), step.set("yi", s.b.y), step.let("choose2", "i", 2);
                cut<upperEdge(N - 1)>(two, s, w, step);
            }
        }
        BasicSegment<T, N> visible{clampedAlong(one.edge, one.at, w),
                                   clampedAlong(two.edge, two.at, w)};
        if constexpr (N > 2)
            if (meet(one, two, w))
                visible.a = visible.b;
        step.left("hold", visible);
        return step.accept("accept", visible);
    }
};

template Algorithm describe<CohenSutherland>();

} // namespace clipping
