// SPDX-License-Identifier: MIT
//
// Kodituwakku-Wijeweera-Chamikara (2013).
//
//   S. R. Kodituwakku, K. R. Wijeweera, M. A. P. Chamikara: An Efficient Algorithm for Line
//   Clipping in Computer Graphics Programming. Ceylon Journal of Science (Physical Sciences) 17,
//   2013, 1-7.
//
// Published is the listing of its appendix. It takes a result shorter than one pixel for a miss,
// and so loses short pieces, steep ones, contacts, and all that lies on an edge. Corrected: every
// comparison is closed, and a miss is known by position: an end is pushed from an edge that the
// other end is beyond as well, which for a miss happens to one of them. The slope stays a fraction,
// each end moves from where it was given, and new ends are held inside the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"

namespace clipping {

struct KodituwakkuWijeweeraChamikara {
    static constexpr About about{
        .key = "kodituwakku-wijeweera-chamikara",
        .abbreviation = "KWC",
        .name = "Kodituwakku-Wijeweera-Chamikara",
        .year = 2013,
        .idea =
            "Push both ends onto the window with y = mx + c, and drop what has shrunk to nothing.",
        .ulps = 24, // README.md, "How far off"
    };

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const bool vertical = asked(s.a.x == s.b.x, 1, s, Edge::None, watch);
        const bool horizontal = asked(s.a.y == s.b.y, 2, s, Edge::None, watch);
        if (!vertical && !horizontal)
            return slanted<form>(s, w, watch);
        if (!vertical)
            return straight<form>(s, w, 0, watch);
        if (!horizontal)
            return straight<form>(s, w, 1, watch);
        if (asked(beyond<form>(s.a.y, w.min.y, w.max.y) || beyond<form>(s.a.x, w.min.x, w.max.x),
                  40, s, Edge::None, watch)) {
            watch("reject", 40, s, Edge::None);
            return std::nullopt;
        }
        watch("accept", 41, s, Edge::None);
        return s;
    }

    /// Whether v is out of the range; as published its limits are out, too.
    template <Form form, class T>
    static constexpr bool beyond(T v, T low, T high)
    {
        if constexpr (form == Form::Published)
            return v <= low || v >= high;
        else
            return v < low || v > high;
    }

    /// The published test for a miss.
    template <class T>
    static constexpr bool underOnePixel(T v, T u)
    {
        return v - u < T(1) && u - v < T(1);
    }

    /// Clips a segment along x (axis 0) or y (axis 1).
    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    straight(const BasicSegment<T>& s, const BasicWindow<T>& w, int axis, Watch& watch)
    {
        const int across = 1 - axis, line = 21 + 10 * axis;
        if (asked(beyond<form>(s.a[across], w.min[across], w.max[across]), line, s, Edge::None,
                  watch)) {
            watch("reject", line, s, Edge::None);
            return std::nullopt;
        }
        BasicSegment<T> visible = s;
        for (const auto end : {&BasicSegment<T>::a, &BasicSegment<T>::b}) {
            T& v = (visible.*end)[axis];
            const T other = end == &BasicSegment<T>::a ? s.b[axis] : s.a[axis];
            const Named number{"i", numberOf(end)};
            if (asked(v < w.min[axis], line + 2, visible, lowerEdge(axis), watch, number)) {
                if (form == Form::Corrected
                    && missed(other < w.min[axis], line + 3, visible, lowerEdge(axis), watch))
                    return std::nullopt;
                v = w.min[axis];
                watch("cut", line + 4, visible, lowerEdge(axis), number);
            } else if (asked(v > w.max[axis], line + 5, visible, upperEdge(axis), watch, number)) {
                if (form == Form::Corrected
                    && missed(other > w.max[axis], line + 6, visible, upperEdge(axis), watch))
                    return std::nullopt;
                v = w.max[axis];
                watch("cut", line + 7, visible, upperEdge(axis), number);
            }
        }
        if (form == Form::Published
            && missed(underOnePixel(visible.a[axis], visible.b[axis]), line + 8, visible,
                      Edge::None, watch))
            return std::nullopt;
        watch("accept", 41, visible, Edge::None);
        return visible;
    }

    /// Which end of the pseudo-code it is.
    template <class T>
    static constexpr int numberOf(glm::vec<2, T> BasicSegment<T>::*end)
    {
        return end == &BasicSegment<T>::a ? 1 : 2;
    }

    /// A test for a miss; if it holds, it is one.
    static constexpr bool missed(bool held, int line, const auto& visible, Edge edge, auto& watch)
    {
        if (asked(held, line, visible, edge, watch))
            watch("reject", line, visible, edge);
        return held;
    }

    /// The line y = mx + c. Corrected: m is dy/dx, and c is each end itself.
    template <class T>
    struct Line {
        T m{}, c{}, dx{}, dy{};
    };
    template <Form form, class T, class Watch>
    static constexpr Line<T> lineThrough(const BasicSegment<T>& s, Watch& watch)
    {
        const auto& [a, b] = s;
        if constexpr (form == Form::Published) {
            const T m = (a.y - b.y) / (a.x - b.x);
            watch("m", 4, s, Edge::None, Named{"m", m});
            const T c = (a.x * b.y - b.x * a.y) / (a.x - b.x);
            watch("c", 5, s, Edge::None, Named{"c", c});
            return {.m = m, .c = c};
        } else {
            const Line<T> line{.dx = b.x - a.x, .dy = b.y - a.y};
            watch("dx, dy", 4, s, Edge::None, Named{"dx", line.dx}, Named{"dy", line.dy});
            return line;
        }
    }

    /// Pushes one end of `visible` onto the edges it is beyond, first left or right, then bottom
    /// or top. The last of those edges; nothing if the other end is beyond the same one.
    template <Form form, class T, class Watch>
    static constexpr std::optional<Edge>
    push(glm::vec<2, T> BasicSegment<T>::*end, const Line<T>& line, BasicSegment<T>& visible,
         const BasicSegment<T>& s, const BasicWindow<T>& w, Watch& watch)
    {
        const glm::vec<2, T>& from = s.*end;
        const glm::vec<2, T>& other = end == &BasicSegment<T>::a ? s.b : s.a;
        glm::vec<2, T>& p = visible.*end;
        const Named number{"i", numberOf(end)};
        const auto ask = [&](bool held, Edge edge, const auto&... values) {
            return asked(held, lineOf(edge), visible, edge, watch, number, values...);
        };
        const Edge side = ask(p.x < w.min.x, Edge::Left)    ? Edge::Left
                          : ask(p.x > w.max.x, Edge::Right) ? Edge::Right
                                                            : Edge::None;
        T rise(0);
        if (side != Edge::None) {
            const T x = side == Edge::Left ? w.min.x : w.max.x;
            if constexpr (form == Form::Published)
                p = {x, line.m * x + line.c};
            else {
                if (missed(side == Edge::Left ? other.x < x : other.x > x, lineOf(side) + 1,
                           visible, side, watch))
                    return std::nullopt;
                rise = line.dy * (x - from.x) / line.dx;
                watch("rise", lineOf(side) + 2, visible, side, Named{"rise", rise});
                p = {x, from.y + rise};
            }
            watch("cut", lineOf(side) + 2, visible, side, number);
        }
        const auto isBeyond = [&](Edge edge, T level) {
            const bool low = edge == Edge::Bottom;
            if (form == Form::Published || side == Edge::None)
                return ask(low ? p.y < level : p.y > level, edge);
            const T gap = level - from.y; // not the rounded height
            return ask(low ? rise < gap : rise > gap, edge, Named{"rise", rise}, Named{"gap", gap});
        };
        const Edge next = isBeyond(Edge::Bottom, w.min.y) ? Edge::Bottom
                          : isBeyond(Edge::Top, w.max.y)  ? Edge::Top
                                                          : Edge::None;
        if (next == Edge::None)
            return side;
        const T y = next == Edge::Bottom ? w.min.y : w.max.y;
        if constexpr (form == Form::Published)
            p = {(y - line.c) / line.m, y};
        else {
            if (missed(next == Edge::Bottom ? other.y < y : other.y > y, lineOf(next) + 1, visible,
                       next, watch))
                return std::nullopt;
            const T run = line.dx * (y - from.y) / line.dy;
            watch("run", lineOf(next) + 2, visible, next, Named{"run", run});
            p = {from.x + run, y};
        }
        watch("cut", lineOf(next) + 2, visible, next, number);
        return next;
    }

    /// Where the pseudo-code asks whether an end is beyond the edge: 7, 10, 13, 16.
    static constexpr int lineOf(Edge edge) { return 4 + 3 * static_cast<int>(edge); }

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> slanted(const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, Watch& watch)
    {
        const Line<T> line = lineThrough<form>(s, watch);
        BasicSegment<T> visible = s;
        const auto edgeA = push<form>(&BasicSegment<T>::a, line, visible, s, w, watch);
        if (!edgeA)
            return std::nullopt;
        const auto edgeB = push<form>(&BasicSegment<T>::b, line, visible, s, w, watch);
        if (!edgeB)
            return std::nullopt;
        if constexpr (form == Form::Corrected)
            visible = {clampedAlong(*edgeA, visible.a, w), clampedAlong(*edgeB, visible.b, w)};
        else if (missed(underOnePixel(visible.a.x, visible.b.x), 19, visible, Edge::None, watch))
            return std::nullopt;
        watch("accept", 41, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<KodituwakkuWijeweeraChamikara>();

} // namespace clipping
