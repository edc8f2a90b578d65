// SPDX-License-Identifier: MIT
//
// Matthes-Drakopoulos (2019), the method this project grew from.
//
//   D. Matthes, V. Drakopoulos: Another Simple but Faster Method for 2D Line Clipping.
//   International Journal of Computer Graphics & Animation 9(1/2/3), 2019, 1-15.
//
// Published is the paper's pseudo-code (its prose has two misprints). Corrected: each end moves
// from where it was given; whether it is then beyond the bottom or top is asked of the way it has
// risen, which is accurate, and not of its rounded height; new ends are held inside the window.

#include "clipping/box/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"

namespace clipping {

struct MatthesDrakopoulos {
    static constexpr About about{
        .key = "matthes-drakopoulos",
        .abbreviation = "MD",
        .name = "Matthes-Drakopoulos",
        .year = 2019,
        .idea =
            "Push both ends to the edges they are beyond; what is still outside was never inside.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr auto box = &matthesDrakopoulosBox;

    static constexpr bool endless = true; // lines and rays too

    /// Pushes one end of `visible` to the edges it is beyond; returns the last of them. An end that
    /// lies at infinity, before a or behind b, is beyond the sides that the line comes from or goes
    /// to.
    template <Form form, bool infinite, class T, class Watch>
    static constexpr Edge push(glm::vec<2, T> BasicSegment<T>::*end, BasicSegment<T>& visible,
                               const BasicSegment<T>& s, const glm::vec<2, T>& d,
                               const BasicWindow<T>& w, Watch& watch)
    {
        const glm::vec<2, T>& from = form == Form::Published ? s.a : s.*end;
        glm::vec<2, T>& p = visible.*end;
        const Named number{"i", end == &BasicSegment<T>::a ? 1 : 2};
        const auto test = [&](bool holds, Edge edge, const auto&... values) {
            watch(yesOrNo(holds), lineOf(edge), visible, edge, number, values...);
            return holds;
        };
        const bool backwards = infinite && end == &BasicSegment<T>::a;
        const Edge edge = infinite ? side(d.x, backwards, Edge::Left, Edge::Right)
                          : test(p.x < w.min.x, Edge::Left)  ? Edge::Left
                          : test(p.x > w.max.x, Edge::Right) ? Edge::Right
                                                             : Edge::None;
        T risen(0);
        if (edge != Edge::None) {
            const T x = edge == Edge::Left ? w.min.x : w.max.x;
            if constexpr (form == Form::Published) {
                const T slope = (s.b.y - s.a.y) / (s.b.x - s.a.x);
                risen = slope * (x - from.x);
                watch("rise", lineOf(edge) + 1, visible, edge, number,
                      Named{"(y2-y1)/(x2-x1)", slope}, Named{"rise", risen});
            } else {
                risen = d.y * (x - from.x) / d.x;
                watch("rise", lineOf(edge) + 1, visible, edge, number, Named{"rise", risen});
            }
            p = {x, risen + from.y};
            watch("cut", lineOf(edge) + 2, visible, edge, number);
        }
        const auto isBeyond = [&](Edge next, T level) {
            const bool low = next == Edge::Bottom;
            if (form == Form::Published || edge == Edge::None)
                return test(low ? p.y < level : p.y > level, next);
            const T gap = level - from.y; // not the rounded height
            return test(low ? risen < gap : risen > gap, next, Named{"rise", risen},
                        Named{"gap", gap});
        };
        const Edge next = infinite && edge == Edge::None
                              ? side(d.y, backwards, Edge::Bottom, Edge::Top)
                          : isBeyond(Edge::Bottom, w.min.y) ? Edge::Bottom
                          : isBeyond(Edge::Top, w.max.y)    ? Edge::Top
                                                            : Edge::None;
        if (next == Edge::None)
            return edge;
        const T y = next == Edge::Bottom ? w.min.y : w.max.y;
        T gone;
        if constexpr (form == Form::Published) {
            const T slope = (s.b.x - s.a.x) / (s.b.y - s.a.y);
            gone = slope * (y - from.y);
            watch("run", lineOf(next) + 1, visible, next, number, Named{"(x2-x1)/(y2-y1)", slope},
                  Named{"run", gone});
        } else {
            gone = d.x * (y - from.y) / d.y;
            watch("run", lineOf(next) + 1, visible, next, number, Named{"run", gone});
        }
        p = {gone + from.x, y};
        watch("cut", lineOf(next) + 2, visible, next, number);
        return next;
    }
    /// Where the pseudo-code asks whether an end is beyond the edge: 7, 10, 13, 16.
    static constexpr int lineOf(Edge edge) { return 4 + 3 * static_cast<int>(edge); }

    /// The side at which infinity lies, along the line or backwards, that runs by d on one axis.
    template <class T>
    static constexpr Edge side(T d, bool backwards, Edge low, Edge high)
    {
        return d == T(0) ? Edge::None : (d > T(0)) != backwards ? high : low;
    }

    /// The edge that it lies wholly beyond, of the two of one axis.
    template <Reach reach, class T>
    static constexpr Edge beyond(T a, T b, T low, T high, Edge lowEdge, Edge highEdge)
    {
        bool below, above;
        if constexpr (reach == Reach::Bounded)
            below = a < low && b < low, above = !below && a > high && b > high;
        else if constexpr (reach == Reach::OneWay)
            below = a < low && b <= a, above = !below && a > high && b >= a;
        else {
            if (a != b)
                return Edge::None;
            below = a < low, above = !below && a > high;
        }
        return below ? lowEdge : above ? highEdge : Edge::None;
    }

    template <Form form, Reach reach = Reach::Bounded, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const auto& [a, b] = s;
        const auto isMissed = [&](int line, const BasicSegment<T>& left, Edge edge) {
            const bool missed = edge != Edge::None;
            watch(yesOrNo(missed), line, left, edge);
            if (missed)
                watch("reject", line + 1, left, edge);
            return missed;
        };
        if (isMissed(1, s, beyond<reach>(a.x, b.x, w.min.x, w.max.x, Edge::Left, Edge::Right))
            || isMissed(3, s, beyond<reach>(a.y, b.y, w.min.y, w.max.y, Edge::Bottom, Edge::Top)))
            return std::nullopt;
        glm::vec<2, T> d{T(0), T(0)};
        if constexpr (form == Form::Corrected)
            d = {b.x - a.x, b.y - a.y};
        BasicSegment<T> visible = s;
        const Edge edgeA =
            push<form, reach == Reach::BothWays>(&BasicSegment<T>::a, visible, s, d, w, watch);
        const Edge edgeB =
            push<form, reach != Reach::Bounded>(&BasicSegment<T>::b, visible, s, d, w, watch);
        if (isMissed(19, visible,
                     beyond<Reach::Bounded>(visible.a.x, visible.b.x, w.min.x, w.max.x, Edge::Left,
                                            Edge::Right)))
            return std::nullopt;
        if constexpr (form == Form::Corrected)
            visible = {clampedAlong(edgeA, visible.a, w), clampedAlong(edgeB, visible.b, w)};
        watch("accept", 21, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<MatthesDrakopoulos>();

} // namespace clipping
