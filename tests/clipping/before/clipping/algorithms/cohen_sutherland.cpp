// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland (1967), after D. Cohen and I. Sutherland's work on a flight simulator, in the
// form that J. Foley, A. van Dam, S. Feiner and J. Hughes print (Computer Graphics: Principles and
// Practice, 2nd edition, 1990, section 3.12).
//
// Corrected: the printed form takes the outcode of a rounded point, which can clear one bit and
// set another for ever. Here a side that has cut an end never cuts it again, so that four cuts are
// the most; each end is cut from where it was given, not from where rounding has left it; and its
// new outcode compares the way it has moved with the way to each edge, both of them accurate.

#include "clipping/box/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/outcode.h"

namespace clipping {

struct CohenSutherland {
    static constexpr About about{
        .key = "cohen-sutherland",
        .abbreviation = "CS",
        .name = "Cohen-Sutherland",
        .year = 1967,
        .idea = "Number the nine regions around the window, and cut an outer end at one edge after "
                "another until its number tells.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr auto box = &cohenSutherlandBox;
    static constexpr int mostCuts = 64; // where the published form is given up

    /// The edge that an end with this outcode is cut at first, its bit, and the pseudo-code's line
    /// that asks for it.
    static constexpr Edge edgeToCut(unsigned code)
    {
        return code & outcode::top      ? Edge::Top
               : code & outcode::bottom ? Edge::Bottom
               : code & outcode::right  ? Edge::Right
                                        : Edge::Left;
    }
    static constexpr unsigned bitOf(Edge edge) { return 1U << (static_cast<int>(edge) - 1); }
    static constexpr int lineOf(Edge edge)
    {
        return 18 - 3 * static_cast<int>(edge);
    } // 6, 9, 12, 15

    /// What a cut gives: the new end, the sides that it is beyond, and how far it has gone on the
    /// other axis.
    template <class T>
    struct Cut {
        glm::vec<2, T> at;
        unsigned code;
        T way;
    };

    /// The end `p` of `s`, cut at the bottom or top edge, which is at height y.
    template <Form form, class T>
    static constexpr Cut<T> cutAtHeight(const BasicSegment<T>& s, const glm::vec<2, T>& p, T y,
                                        const BasicWindow<T>& w)
    {
        const T run = (s.b.x - s.a.x) * (y - p.y) / (s.b.y - s.a.y);
        const glm::vec<2, T> at{p.x + run, y};
        if constexpr (form == Form::Published)
            return {at, outcodeOf(at, w), run};
        else if (run < w.min.x - p.x)
            return {at, outcode::left, run};
        else
            return {at, run > w.max.x - p.x ? outcode::right : 0, run};
    }

    /// The end `p` of `s`, cut at the left or right edge, which is at x.
    template <Form form, class T>
    static constexpr Cut<T> cutAtWidth(const BasicSegment<T>& s, const glm::vec<2, T>& p, T x,
                                       const BasicWindow<T>& w)
    {
        const T rise = (s.b.y - s.a.y) * (x - p.x) / (s.b.x - s.a.x);
        const glm::vec<2, T> at{x, p.y + rise};
        if constexpr (form == Form::Published)
            return {at, outcodeOf(at, w), rise};
        else if (rise < w.min.y - p.y)
            return {at, outcode::bottom, rise};
        else
            return {at, rise > w.max.y - p.y ? outcode::top : 0, rise};
    }

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        BasicSegment<T> visible = s;
        unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        unsigned doneA = 0, doneB = 0; // the sides that have cut an end
        Edge lastA = Edge::None, lastB = Edge::None;
        watch("outcodes", 1, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        for (int cuts = 0; (codeA | codeB) != 0; ++cuts) {
            watch("no", 3, visible, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
            if ((codeA & codeB) != 0) {
                watch("reject", 4, visible, Edge::None, Named{"code1", codeA},
                      Named{"code2", codeB});
                return std::nullopt;
            }
            watch("no", 4, visible, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
            if (cuts == mostCuts) {
                watch("give up", 19, visible, Edge::None, Named{"code1", codeA},
                      Named{"code2", codeB});
                watch.didNotEnd();
                return std::nullopt;
            }
            const bool first = codeA != 0;
            const unsigned code = first ? codeA : codeB;
            const Named number{"i", first ? 1 : 2};
            watch("end", 5, visible, Edge::None, number, Named{"code", code});
            const BasicSegment<T>& line = form == Form::Published ? visible : s;
            const glm::vec<2, T>& from = form == Form::Published || first ? line.a : line.b;
            const Edge edge = edgeToCut(code);
            watch("yes", lineOf(edge), visible, edge, number, Named{"code", code});
            const Cut<T> cut = edge == Edge::Top      ? cutAtHeight<form>(line, from, w.max.y, w)
                               : edge == Edge::Bottom ? cutAtHeight<form>(line, from, w.min.y, w)
                               : edge == Edge::Right  ? cutAtWidth<form>(line, from, w.max.x, w)
                                                      : cutAtWidth<form>(line, from, w.min.x, w);
            watch(axisOf(edge) == 1 ? "run" : "rise", lineOf(edge) + 1, visible, edge, number,
                  Named{axisOf(edge) == 1 ? "run" : "rise", cut.way});
            (first ? visible.a : visible.b) = cut.at;
            (first ? lastA : lastB) = edge;
            (first ? doneA : doneB) |= bitOf(edge);
            (first ? codeA : codeB) = cut.code;
            watch("cut", lineOf(edge) + 2, visible, edge, number);
            if constexpr (form == Form::Corrected)
                (first ? codeA : codeB) &= ~(first ? doneA : doneB);
            watch("outcode", 18, visible, edge, number, Named{"code1", codeA},
                  Named{"code2", codeB});
        }
        if constexpr (form == Form::Corrected)
            visible = {clampedAlong(lastA, visible.a, w), clampedAlong(lastB, visible.b, w)};
        watch("accept", 3, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<CohenSutherland>();

} // namespace clipping
