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
        if (s.a.x != s.b.x) {
            if (s.a.y != s.b.y)
                return slanted<form>(s, w, watch);
            return straight<form>(s, w, 0, watch);
        }
        if (s.a.y != s.b.y)
            return straight<form>(s, w, 1, watch);
        if (beyond<form>(s.a.y, w.min.y, w.max.y) || beyond<form>(s.a.x, w.min.x, w.max.x)) {
            watch("reject", 17, s, Edge::None);
            return std::nullopt;
        }
        watch("accept", 18, s, Edge::None);
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
        const int across = 1 - axis, line = 10 + 4 * axis;
        if (beyond<form>(s.a[across], w.min[across], w.max[across])) {
            watch("reject", line, s, Edge::None);
            return std::nullopt;
        }
        BasicSegment<T> visible = s;
        bool missed = false;
        for (const auto end : {&BasicSegment<T>::a, &BasicSegment<T>::b}) {
            T& v = (visible.*end)[axis];
            const T other = end == &BasicSegment<T>::a ? s.b[axis] : s.a[axis];
            if (v < w.min[axis]) {
                missed = form == Form::Corrected && other < w.min[axis];
                v = w.min[axis];
            } else if (v > w.max[axis]) {
                missed = form == Form::Corrected && other > w.max[axis];
                v = w.max[axis];
            }
            if (missed)
                break;
        }
        watch("cut", line + 1, visible, Edge::None);
        if constexpr (form == Form::Published)
            missed = underOnePixel(visible.a[axis], visible.b[axis]);
        if (missed) {
            watch("reject", line + 2, visible, Edge::None);
            return std::nullopt;
        }
        watch("accept", 18, visible, Edge::None);
        return visible;
    }

    /// The line y = mx + c. Corrected: m is dy/dx, and c is each end itself.
    template <class T>
    struct Line {
        T m{}, c{}, dx{}, dy{};
    };
    template <Form form, class T>
    static constexpr Line<T> lineThrough(const BasicSegment<T>& s)
    {
        const auto& [a, b] = s;
        if constexpr (form == Form::Published)
            return {.m = (a.y - b.y) / (a.x - b.x), .c = (a.x * b.y - b.x * a.y) / (a.x - b.x)};
        else
            return {.dx = b.x - a.x, .dy = b.y - a.y};
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
        const Edge side = p.x < w.min.x ? Edge::Left : p.x > w.max.x ? Edge::Right : Edge::None;
        T rise(0);
        if (side != Edge::None) {
            const T x = side == Edge::Left ? w.min.x : w.max.x;
            if constexpr (form == Form::Published)
                p = {x, line.m * x + line.c};
            else {
                if (side == Edge::Left ? other.x < x : other.x > x)
                    return watch("reject", 4, visible, side), std::nullopt;
                rise = line.dy * (x - from.x) / line.dx;
                p = {x, from.y + rise};
            }
            watch("cut", side == Edge::Left ? 4 : 5, visible, side);
        }
        const bool ask = form == Form::Corrected && side != Edge::None; // not the rounded height
        const Edge next = (ask ? rise < w.min.y - from.y : p.y < w.min.y)   ? Edge::Bottom
                          : (ask ? rise > w.max.y - from.y : p.y > w.max.y) ? Edge::Top
                                                                            : Edge::None;
        if (next == Edge::None)
            return side;
        const T y = next == Edge::Bottom ? w.min.y : w.max.y;
        if constexpr (form == Form::Published)
            p = {(y - line.c) / line.m, y};
        else {
            if (next == Edge::Bottom ? other.y < y : other.y > y)
                return watch("reject", 6, visible, next), std::nullopt;
            p = {from.x + line.dx * (y - from.y) / line.dy, y};
        }
        watch("cut", next == Edge::Bottom ? 6 : 7, visible, next);
        return next;
    }

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> slanted(const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, Watch& watch)
    {
        const Line<T> line = lineThrough<form>(s);
        if constexpr (form == Form::Published)
            watch("line", 2, s, Edge::None, Named{"m", line.m}, Named{"c", line.c});
        else
            watch("line", 2, s, Edge::None, Named{"dx", line.dx}, Named{"dy", line.dy});
        BasicSegment<T> visible = s;
        const auto edgeA = push<form>(&BasicSegment<T>::a, line, visible, s, w, watch);
        if (!edgeA)
            return std::nullopt;
        const auto edgeB = push<form>(&BasicSegment<T>::b, line, visible, s, w, watch);
        if (!edgeB)
            return std::nullopt;
        if constexpr (form == Form::Corrected)
            visible = {clampedAlong(*edgeA, visible.a, w), clampedAlong(*edgeB, visible.b, w)};
        else if (underOnePixel(visible.a.x, visible.b.x)) {
            watch("reject", 8, visible, Edge::None);
            return std::nullopt;
        }
        watch("accept", 18, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<KodituwakkuWijeweeraChamikara>();

} // namespace clipping
