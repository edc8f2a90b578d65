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

    /// How far the line rises, and runs, from `p` to the edge at x, or at y.
    template <Form form, class T>
    static constexpr T rise(const BasicSegment<T>& s, const glm::vec<2, T>& d, T x, T from)
    {
        if constexpr (form == Form::Published)
            return (s.b.y - s.a.y) / (s.b.x - s.a.x) * (x - from);
        else
            return d.y * (x - from) / d.x;
    }
    template <Form form, class T>
    static constexpr T run(const BasicSegment<T>& s, const glm::vec<2, T>& d, T y, T from)
    {
        if constexpr (form == Form::Published)
            return (s.b.x - s.a.x) / (s.b.y - s.a.y) * (y - from);
        else
            return d.x * (y - from) / d.y;
    }

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
        const bool backwards = infinite && end == &BasicSegment<T>::a;
        Edge edge = infinite        ? side(d.x, backwards, Edge::Left, Edge::Right)
                    : p.x < w.min.x ? Edge::Left
                    : p.x > w.max.x ? Edge::Right
                                    : Edge::None;
        T risen(0);
        if (edge != Edge::None) {
            const T x = edge == Edge::Left ? w.min.x : w.max.x;
            risen = rise<form>(s, d, x, from.x);
            p = {x, risen + from.y};
            watch("cut", edge == Edge::Left ? 4 : 6, visible, edge, Named{"rise", risen});
        }
        const bool ask = form == Form::Corrected && edge != Edge::None; // not the rounded height
        const Edge next = infinite && edge == Edge::None
                              ? side(d.y, backwards, Edge::Bottom, Edge::Top)
                          : (ask ? risen < w.min.y - from.y : p.y < w.min.y) ? Edge::Bottom
                          : (ask ? risen > w.max.y - from.y : p.y > w.max.y) ? Edge::Top
                                                                             : Edge::None;
        if (next == Edge::None)
            return edge;
        const T y = next == Edge::Bottom ? w.min.y : w.max.y;
        const T gone = run<form>(s, d, y, from.y);
        p = {gone + from.x, y};
        watch("cut", next == Edge::Bottom ? 8 : 10, visible, next, Named{"run", gone});
        return next;
    }

    /// The side at which infinity lies, along the line or backwards, that runs by d on one axis.
    template <class T>
    static constexpr Edge side(T d, bool backwards, Edge low, Edge high)
    {
        return d == T(0) ? Edge::None : (d > T(0)) != backwards ? high : low;
    }

    /// Whether it lies wholly beyond one edge.
    template <Reach reach, class T>
    static constexpr bool isBeyond(T a, T b, T low, T high)
    {
        if constexpr (reach == Reach::Bounded)
            return (a < low && b < low) || (a > high && b > high);
        else if constexpr (reach == Reach::OneWay)
            return (a < low && b <= a) || (a > high && b >= a);
        else
            return a == b && (a < low || a > high);
    }

    template <Form form, Reach reach = Reach::Bounded, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const auto& [a, b] = s;
        if (isBeyond<reach>(a.x, b.x, w.min.x, w.max.x)
            || isBeyond<reach>(a.y, b.y, w.min.y, w.max.y)) {
            watch("reject", 1, s, Edge::None);
            return std::nullopt;
        }
        glm::vec<2, T> d{T(0), T(0)};
        if constexpr (form == Form::Corrected)
            d = {b.x - a.x, b.y - a.y};
        BasicSegment<T> visible = s;
        const Edge edgeA =
            push<form, reach == Reach::BothWays>(&BasicSegment<T>::a, visible, s, d, w, watch);
        const Edge edgeB =
            push<form, reach != Reach::Bounded>(&BasicSegment<T>::b, visible, s, d, w, watch);
        if (isBeyond<Reach::Bounded>(visible.a.x, visible.b.x, w.min.x, w.max.x)) {
            watch("reject", 11, visible, Edge::None);
            return std::nullopt;
        }
        if constexpr (form == Form::Corrected)
            visible = {clampedAlong(edgeA, visible.a, w), clampedAlong(edgeB, visible.b, w)};
        watch("accept", 12, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<MatthesDrakopoulos>();

} // namespace clipping
