// SPDX-License-Identifier: MIT
//
// Nicholl-Lee-Nicholl (1987).
//
//   T. M. Nicholl, D. T. Lee, R. A. Nicholl: An Efficient New Algorithm for 2-D Line Clipping: Its
//   Development and Analysis. Computer Graphics 21(4) (SIGGRAPH '87), 253-262.
//
// The nine regions that the first end may lie in are turned and mirrored into three; every
// procedure below works in a frame where its own case is the one it was written for. It changes
// `s` into what is visible, and says whether anything is.
//
// Corrected: a new end is held inside the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/symmetry.h"

namespace clipping {

struct NichollLeeNicholl {
    static constexpr About about{
        .key = "nicholl-lee-nicholl",
        .abbreviation = "NLN",
        .name = "Nicholl-Lee-Nicholl",
        .year = 1987,
        .idea =
            "Find the first end's region, and compare slopes with the window's corners, so that "
            "only the intersections that are returned are ever computed.",
        .ulps = 24, // README.md, "How far off"
    };

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        BasicSegment<T> visible = s;
        if (!Procedures<form, T>::clip(visible, w, watch))
            return std::nullopt;
        watch("accept", 6, visible, Edge::None);
        return visible;
    }

    template <Form form, class T>
    struct Procedures {
        using S = BasicSegment<T>;
        using W = BasicWindow<T>;
        using V = glm::vec<2, T>;

        /// A new end on `edge`: its side coordinate is the edge's own.
        static constexpr V held(Edge edge, V p, const W& w)
        {
            if constexpr (form == Form::Corrected)
                return clampedAlong(edge, p, w);
            return p;
        }
        static constexpr bool reject(int line, const S& s, Edge edge, auto& watch)
        {
            watch("reject", line, s, edge);
            return false;
        }
        static constexpr void cutA(int line, S& s, Edge edge, V p, const W& w, auto& watch)
        {
            s.a = held(edge, p, w);
            watch("cut a", line, s, edge);
        }
        static constexpr void cutB(int line, S& s, Edge edge, V p, const W& w, auto& watch)
        {
            s.b = held(edge, p, w);
            watch("cut b", line, s, edge);
        }

        static constexpr bool clip(S& s, const W& w, auto& watch)
        {
            if (asked(s.a.x < w.min.x, 1, s, Edge::Left, watch))
                return fromLeft(s, w, watch);
            if (asked(s.a.x > w.max.x, 2, s, Edge::Right, watch))
                return in<HalfTurn>(s, w, watch, [](auto&... x) { return fromLeft(x...); });
            return fromCentre(s, w, watch);
        }

        /// a is neither left nor right of the window.
        static constexpr bool fromCentre(S& s, const W& w, auto& watch)
        {
            if (asked(s.a.y > w.max.y, 3, s, Edge::Top, watch))
                return in<ThreeQuarterTurn>(s, w, watch, [](auto&... x) { return fromEdge(x...); });
            if (asked(s.a.y < w.min.y, 4, s, Edge::Bottom, watch))
                return in<QuarterTurn>(s, w, watch, [](auto&... x) { return fromEdge(x...); });
            watch("inside", 5, s, Edge::None);
            return fromInside(s, w, watch);
        }

        /// a is left of the window.
        static constexpr bool fromLeft(S& s, const W& w, auto& watch)
        {
            if (asked(s.b.x < w.min.x, 7, s, Edge::Left, watch))
                return reject(7, s, Edge::Left, watch);
            if (asked(s.a.y > w.max.y, 8, s, Edge::Top, watch))
                return fromCorner(s, w, watch);
            if (asked(s.a.y < w.min.y, 9, s, Edge::Bottom, watch))
                return in<MirrorInX>(s, w, watch, [](auto&... x) { return fromCorner(x...); });
            watch("beside", 10, s, Edge::Left);
            return fromEdge(s, w, watch);
        }

        /// a is beyond the top left corner.
        static constexpr bool fromCorner(S& s, const W& w, auto& watch)
        {
            if (asked(s.b.y > w.max.y, 11, s, Edge::Top, watch))
                return reject(11, s, Edge::Top, watch);
            const V d = extent(12, s, watch);
            const T top = (w.max.y - s.a.y) * d.x, left = (w.min.x - s.a.x) * d.y;
            watch("products", 13, s, Edge::Left, Named{"pymax", top}, Named{"pxmin", left});
            if (asked(top > left, 14, s, Edge::Left, watch, Named{"pymax", top},
                      Named{"pxmin", left}))
                return acrossLeft(s, w, watch, d, left);
            watch("mirror", 15, s, Edge::Top);
            return in<MirrorInDiagonal>(s, w, watch, [&](S& t, const W& v, auto& inner) {
                return acrossLeft(t, v, inner, MirrorInDiagonal::of(d), top);
            });
        }

        /// The line comes from the top left corner's region and passes below that corner.
        static constexpr bool acrossLeft(S& s, const W& w, auto& watch, const V& d, T left)
        {
            const V a = s.a;
            if (asked(!(s.b.y >= w.min.y), 16, s, Edge::Bottom, watch)) {
                const T bottom = (w.min.y - a.y) * d.x;
                watch("product", 17, s, Edge::Bottom, Named{"pymin", bottom});
                if (asked(bottom > left, 18, s, Edge::Left, watch, Named{"pymin", bottom},
                          Named{"pxmin", left}))
                    return reject(18, s, Edge::Bottom, watch);
                leaveBelow(s, w, watch, d, bottom);
            } else if (asked(s.b.x > w.max.x, 20, s, Edge::Right, watch))
                cutB(21, s, Edge::Right, {w.max.x, a.y + (w.max.x - a.x) * d.y / d.x}, w, watch);
            cutA(22, s, Edge::Left, {w.min.x, a.y + left / d.x}, w, watch);
            return true;
        }

        /// b is below the window: the line leaves it at the bottom, or at the right edge.
        static constexpr void leaveBelow(S& s, const W& w, auto& watch, const V& d, T bottom)
        {
            if (asked(s.b.x > w.max.x, 23, s, Edge::Right, watch)) {
                const T right = (w.max.x - s.a.x) * d.y;
                watch("product", 24, s, Edge::Right, Named{"pxmax", right});
                if (asked(!(bottom > right), 25, s, Edge::Right, watch, Named{"pymin", bottom},
                          Named{"pxmax", right}))
                    return cutB(26, s, Edge::Right, {w.max.x, s.a.y + right / d.x}, w, watch);
            }
            cutB(27, s, Edge::Bottom, {s.a.x + bottom / d.y, w.min.y}, w, watch);
        }

        /// a is beyond the left edge.
        static constexpr bool fromEdge(S& s, const W& w, auto& watch)
        {
            if (asked(s.b.x < w.min.x, 28, s, Edge::Left, watch))
                return reject(28, s, Edge::Left, watch);
            if (asked(s.b.y < w.min.y, 29, s, Edge::Bottom, watch))
                return fromEdgeDown(s, w, watch);
            if (asked(s.b.y > w.max.y, 30, s, Edge::Top, watch))
                return in<MirrorInX>(s, w, watch, [](auto&... x) { return fromEdgeDown(x...); });
            const V a = s.a, d = extent(31, s, watch);
            if (asked(s.b.x > w.max.x, 32, s, Edge::Right, watch))
                cutB(33, s, Edge::Right, {w.max.x, a.y + d.y * (w.max.x - a.x) / d.x}, w, watch);
            cutA(34, s, Edge::Left, {w.min.x, a.y + d.y * (w.min.x - a.x) / d.x}, w, watch);
            return true;
        }

        /// a is beyond the left edge, and b below the window.
        static constexpr bool fromEdgeDown(S& s, const W& w, auto& watch)
        {
            const V a = s.a, d = extent(35, s, watch);
            const T left = (w.min.x - a.x) * d.y, bottom = (w.min.y - a.y) * d.x;
            watch("products", 36, s, Edge::Left, Named{"pxmin", left}, Named{"pymin", bottom});
            if (asked(bottom > left, 37, s, Edge::Left, watch, Named{"pymin", bottom},
                      Named{"pxmin", left}))
                return reject(37, s, Edge::Bottom, watch);
            leaveBelow(s, w, watch, d, bottom);
            cutA(39, s, Edge::Left, {w.min.x, a.y + left / d.x}, w, watch);
            return true;
        }

        static constexpr bool fromInside(S& s, const W& w, auto& watch)
        {
            if (asked(s.b.x < w.min.x, 40, s, Edge::Left, watch))
                return toLeft(s, w, watch);
            if (asked(s.b.x > w.max.x, 41, s, Edge::Right, watch))
                return in<HalfTurn>(s, w, watch, [](auto&... x) { return toLeft(x...); });
            if (asked(s.b.y > w.max.y, 42, s, Edge::Top, watch))
                toHeight(43, s, Edge::Top, w.max.y, w, watch);
            else if (asked(s.b.y < w.min.y, 44, s, Edge::Bottom, watch))
                toHeight(45, s, Edge::Bottom, w.min.y, w, watch);
            return true;
        }
        static constexpr void toHeight(int line, S& s, Edge edge, T y, const W& w, auto& watch)
        {
            const V d{s.b.x - s.a.x, s.b.y - s.a.y};
            cutB(line, s, edge, {s.a.x + d.x * (y - s.a.y) / d.y, y}, w, watch);
        }

        /// a is inside, and b left of the window.
        static constexpr bool toLeft(S& s, const W& w, auto& watch)
        {
            if (asked(s.b.y > w.max.y, 46, s, Edge::Top, watch))
                return toCorner(s, w, watch);
            if (asked(s.b.y < w.min.y, 47, s, Edge::Bottom, watch))
                return in<QuarterTurn>(s, w, watch, [](auto&... x) { return toCorner(x...); });
            const V d{s.b.x - s.a.x, s.b.y - s.a.y};
            cutB(48, s, Edge::Left, {w.min.x, s.a.y + d.y * (w.min.x - s.a.x) / d.x}, w, watch);
            return true;
        }

        /// a is inside, and b beyond the top left corner.
        static constexpr bool toCorner(S& s, const W& w, auto& watch)
        {
            const V d = extent(49, s, watch);
            const T left = d.y * (w.min.x - s.a.x), top = d.x * (w.max.y - s.a.y);
            watch("products", 50, s, Edge::Top, Named{"pxmin", left}, Named{"pymax", top});
            if (asked(top > left, 51, s, Edge::Top, watch, Named{"pymax", top},
                      Named{"pxmin", left}))
                cutB(52, s, Edge::Top, {s.a.x + top / d.y, w.max.y}, w, watch);
            else
                cutB(53, s, Edge::Left, {w.min.x, s.a.y + left / d.x}, w, watch);
            return true;
        }

        /// How far b is from a on each axis.
        static constexpr V extent(int line, const S& s, auto& watch)
        {
            const V d{s.b.x - s.a.x, s.b.y - s.a.y};
            watch("dx, dy", line, s, Edge::None, Named{"dx", d.x}, Named{"dy", d.y});
            return d;
        }

        /// Runs a procedure in another frame, and turns what it leaves back.
        template <class Symmetry>
        static constexpr bool in(S& s, const W& w, auto& watch, auto procedure)
        {
            S turned{Symmetry::of(s.a), Symmetry::of(s.b)};
            const W window = Symmetry::window(w);
            auto inner = turnedWatch<typename Symmetry::Inverse>(watch);
            const bool visible = procedure(turned, window, inner);
            using Back = typename Symmetry::Inverse;
            s = {Back::of(turned.a), Back::of(turned.b)};
            return visible;
        }
    };
};

template Algorithm describe<NichollLeeNicholl>();

} // namespace clipping
