// SPDX-License-Identifier: MIT
//
// Cyrus-Beck (1978), which clips against any convex polygon; here the polygon is the window.
//
//   M. Cyrus, J. Beck: Generalized Two- and Three-Dimensional Clipping.
//   Computers & Graphics 3(1), 1978, 23-28.
//
// Corrected: the inner normals have length 1, so that a window without height or width keeps
// them and no triple product arises; a new end takes the coordinate of the edge that cut it, and
// its other coordinate is held inside the window.

#include "clipping/along.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"
#include "clipping/polygon/uses.h"

#include <array>

namespace clipping {

struct CyrusBeck {
    static constexpr About about{
        .key = "cyrus-beck",
        .abbreviation = "CB",
        .name = "Cyrus-Beck",
        .year = 1978,
        .idea =
            "Ask the inner normal of every edge whether the segment enters or leaves there; the "
            "last entry and the first exit bound what is visible.",
        .ulps = 24, // README.md, "How far off"
    };
    static constexpr bool endless = true; // lines and rays too
    static constexpr const auto* polygon = &cyrusBeckPolygon;
    static constexpr auto box = &cyrusBeckBox;
    static constexpr std::array edges{Edge::Bottom, Edge::Right, Edge::Top, Edge::Left};

    template <class T>
    using Corners = std::array<glm::vec<2, T>, 4>;

    /// The normal of edge i of the polygon, pointing inside.
    template <Form form, class T>
    static constexpr glm::vec<2, T> innerNormal(const Corners<T>& corners, std::size_t i)
    {
        const auto& from = corners[i];
        const auto& to = corners[(i + 1) % 4];
        if constexpr (form == Form::Published)
            return {from.y - to.y, to.x - from.x};
        constexpr Corners<int> unit{{{0, 1}, {-1, 0}, {0, -1}, {1, 0}}};
        return {T(unit[i].x), T(unit[i].y)};
    }

    template <Form form, Reach reach = Reach::Bounded, class T, class Watch>
    // NOLINTNEXTLINE(readability-function-size): line by line as the source has it
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const Corners<T> corners{{w.min, {w.max.x, w.min.y}, w.max, {w.min.x, w.max.y}}};
        const T dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
        T entry = beginning<reach, T>(), exit = ending<reach, T>();
        Edge entryEdge = Edge::None, exitEdge = Edge::None;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto normal = innerNormal<form>(corners, i);
            const T speed = normal.x * dx + normal.y * dy;
            watch("D", 3, s, edges[i], Named{"nx", normal.x}, Named{"ny", normal.y},
                  Named{"D", speed});
            const T depth = normal.x * (s.a.x - corners[i].x) + normal.y * (s.a.y - corners[i].y);
            watch("N", 4, s, edges[i], Named{"N", depth});
            if (speed == T(0)) {
                watch("yes", 5, s, edges[i], Named{"D", speed});
                if (depth < T(0)) {
                    watch("reject", 6, s, edges[i], Named{"D", speed}, Named{"N", depth});
                    return std::nullopt;
                }
                watch("no", 6, s, edges[i], Named{"N", depth});
                continue;
            }
            watch("no", 5, s, edges[i], Named{"D", speed});
            const T t = -depth / speed;
            watch("t", 8, s, edges[i], Named{"D", speed}, Named{"N", depth}, Named{"t", t});
            if (speed > T(0)) {
                watch("yes", 9, s, edges[i], Named{"D", speed});
                if (t > entry) {
                    watch("yes", 10, s, edges[i], Named{"t", t}, Named{"tE", entry});
                    entry = t, entryEdge = edges[i];
                    watch("entry", 11, s, edges[i], Named{"tE", entry});
                } else
                    watch("no", 10, s, edges[i], Named{"t", t}, Named{"tE", entry});
            } else {
                watch("no", 9, s, edges[i], Named{"D", speed});
                if (t < exit) {
                    watch("yes", 12, s, edges[i], Named{"t", t}, Named{"tL", exit});
                    exit = t, exitEdge = edges[i];
                    watch("exit", 13, s, edges[i], Named{"tL", exit});
                } else
                    watch("no", 12, s, edges[i], Named{"t", t}, Named{"tL", exit});
            }
        }
        if (entry > exit) {
            watch("reject", 14, s, Edge::None, Named{"tE", entry}, Named{"tL", exit});
            return std::nullopt;
        }
        watch("no", 14, s, Edge::None, Named{"tE", entry}, Named{"tL", exit});
        BasicSegment<T> visible = s;
        if (reach != Reach::Bounded || exit < T(1)) {
            watch("yes", 15, s, exitEdge, Named{"tL", exit});
            visible.b = along<form>(s, {dx, dy}, exit, exitEdge, w);
            watch("cut b", 16, visible, exitEdge, Named{"tL", exit});
        } else {
            watch("no", 15, s, exitEdge, Named{"tL", exit});
            if constexpr (form == Form::Corrected)
                visible.b = clamped(s.b, w);
        }
        if (reach == Reach::BothWays || entry > T(0)) {
            watch("yes", 17, visible, entryEdge, Named{"tE", entry});
            visible.a = along<form>(s, {dx, dy}, entry, entryEdge, w);
            if constexpr (form == Form::Corrected)
                if (exitEdge != Edge::None && entry == exit)
                    visible.a = visible.b;
            watch("cut a", 18, visible, entryEdge, Named{"tE", entry});
        } else {
            watch("no", 17, visible, entryEdge, Named{"tE", entry});
            if constexpr (form == Form::Corrected)
                visible.a = clamped(s.a, w);
        }
        watch("accept", 19, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<CyrusBeck>();

} // namespace clipping
