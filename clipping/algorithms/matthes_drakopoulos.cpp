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

    /// Pushes one end of `visible` to the edges it is beyond; returns the last of them.
    template <Form form, class T, class Watch>
    static constexpr Edge push(glm::vec<2, T> BasicSegment<T>::*end, BasicSegment<T>& visible,
                               const BasicSegment<T>& s, const glm::vec<2, T>& d,
                               const BasicWindow<T>& w, Watch& watch)
    {
        const glm::vec<2, T>& from = form == Form::Published ? s.a : s.*end;
        glm::vec<2, T>& p = visible.*end;
        Edge edge = p.x < w.min.x ? Edge::Left : p.x > w.max.x ? Edge::Right : Edge::None;
        T risen(0);
        if (edge != Edge::None) {
            const T x = edge == Edge::Left ? w.min.x : w.max.x;
            risen = rise<form>(s, d, x, from.x);
            p = {x, risen + from.y};
            watch("cut", edge == Edge::Left ? 4 : 6, visible, edge, Named{"rise", risen});
        }
        const bool ask = form == Form::Corrected && edge != Edge::None; // not the rounded height
        const Edge next = (ask ? risen < w.min.y - from.y : p.y < w.min.y)   ? Edge::Bottom
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

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const auto& [a, b] = s;
        if ((a.x < w.min.x && b.x < w.min.x) || (a.x > w.max.x && b.x > w.max.x)
            || (a.y < w.min.y && b.y < w.min.y) || (a.y > w.max.y && b.y > w.max.y)) {
            watch("reject", 1, s, Edge::None);
            return std::nullopt;
        }
        glm::vec<2, T> d{T(0), T(0)};
        if constexpr (form == Form::Corrected)
            d = {b.x - a.x, b.y - a.y};
        BasicSegment<T> visible = s;
        const Edge edgeA = push<form>(&BasicSegment<T>::a, visible, s, d, w, watch);
        const Edge edgeB = push<form>(&BasicSegment<T>::b, visible, s, d, w, watch);
        if ((visible.a.x < w.min.x && visible.b.x < w.min.x)
            || (visible.a.x > w.max.x && visible.b.x > w.max.x)) {
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
