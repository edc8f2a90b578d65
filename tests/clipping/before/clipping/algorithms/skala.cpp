// SPDX-License-Identifier: MIT
//
// Skala (2005).
//
//   V. Skala: A New Approach to Line and Line Segment Clipping in Homogeneous Coordinates.
//   The Visual Computer 21(11), 2005, 905-914.
//
// Corrected: the origin is the segment's first end, so that the line has no third coefficient to
// lose its digits in; a line that seems to have the whole window on its left, or on itself, is
// asked again with "strictly"; the table tells the edge of entry from that of exit, so that the
// ends keep their order; a new end takes the coordinate of its edge and is held inside the window.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/outcode.h"
#include "clipping/polygon/uses.h"

#include <array>

namespace clipping {

struct Skala {
    static constexpr About about{
        .key = "skala",
        .abbreviation = "Skala",
        .name = "Skala",
        .year = 2005,
        .idea =
            "Ask on which side of the line each corner of the window lies; the pattern names the "
            "two edges that the line crosses.",
        .ulps = 24, // README.md, "How far off"
    };

    static constexpr bool endless = true; // lines and rays too
    static constexpr const auto* polygon = &skalaPolygon;
    static constexpr const auto* searchedPolygon = &skalaSearchedPolygon;

    /// The edges e0 to e3, counter-clockwise; edge k joins corner k to the next.
    static constexpr std::array edges{Edge::Bottom, Edge::Right, Edge::Top, Edge::Left};

    /// One row of the table: where the line enters and leaves if the corners whose bits are set
    /// lie on its left. The paper does not tell the two apart: it has TAB1 and TAB2, with the
    /// outcode bit MASK of TAB1.
    struct Crossing {
        int enter, leave, tab1, tab2;
        unsigned mask;
    };
    static constexpr Crossing none{-1, -1, -1, -1, 0};
    static constexpr std::array<Crossing, 16> crossings{{
        none,
        {0, 3, 0, 3, 4},
        {1, 0, 0, 1, 4},
        {1, 3, 1, 3, 2},
        {2, 1, 1, 2, 2},
        none,
        {2, 0, 0, 2, 4},
        {2, 3, 2, 3, 8},
        {3, 2, 2, 3, 8},
        {0, 2, 0, 2, 4},
        none,
        {1, 2, 1, 2, 2},
        {3, 1, 1, 3, 2},
        {0, 1, 0, 1, 4},
        {3, 0, 0, 3, 4},
        none,
    }};

    /// The line a*x + b*y + c = 0 through the segment, as the paper has it.
    template <class T>
    using Line = glm::vec<3, T>;

    /// The homogeneous point where the line meets edge k, divided out.
    template <class T>
    static constexpr glm::vec<2, T> meet(const Line<T>& p, int k, const BasicWindow<T>& w)
    {
        const Line<T> e = k == 0   ? Line<T>{T(0), T(1), -w.min.y}
                          : k == 1 ? Line<T>{T(1), T(0), -w.max.x}
                          : k == 2 ? Line<T>{T(0), T(1), -w.max.y}
                                   : Line<T>{T(1), T(0), -w.min.x};
        const T x = p.y * e.z - p.z * e.y, y = p.z * e.x - p.x * e.z, z = p.x * e.y - p.y * e.x;
        return {x / z, y / z};
    }

    template <Form form, Reach reach = Reach::Bounded, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        if constexpr (reach != Reach::Bounded)
            return clipEndless<reach>(s, w, watch);
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        if (asked((codeA | codeB) == 0, 2, s, Edge::None, watch)) {
            watch("accept", 2, s, Edge::None);
            return s;
        }
        if (asked((codeA & codeB) != 0, 3, s, Edge::None, watch)) {
            watch("reject", 3, s, Edge::None);
            return std::nullopt;
        }
        if constexpr (form == Form::Published)
            return crossed(s, w, codeA, codeB, watch);
        else
            return crossedFromA(s, w, codeA, codeB, watch);
    }

    /// A line has no ends to encode, a ray one; where there is none, there is a cut.
    template <Reach reach, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    clipEndless(const BasicSegment<T>& s, const BasicWindow<T>& w, Watch& watch)
    {
        constexpr unsigned none = ~0U;
        if constexpr (reach == Reach::BothWays)
            return crossedFromA(s, w, none, none, watch);
        const unsigned code = outcodeOf(s.a, w);
        watch("outcodes", 1, s, Edge::None, Named{"code1", code});
        if (((code & outcode::left) && s.b.x <= s.a.x)
            || ((code & outcode::right) && s.b.x >= s.a.x)
            || ((code & outcode::bottom) && s.b.y <= s.a.y)
            || ((code & outcode::top) && s.b.y >= s.a.y)) {
            watch("reject", 3, s, Edge::None);
            return std::nullopt;
        }
        return crossedFromA(s, w, code, none, watch);
    }

    template <class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> crossed(const BasicSegment<T>& s,
                                                            const BasicWindow<T>& w, unsigned codeA,
                                                            unsigned codeB, Watch& watch)
    {
        const Line<T> p{s.a.y - s.b.y, s.b.x - s.a.x, s.a.x * s.b.y - s.b.x * s.a.y};
        watch("line", 4, s, Edge::None, Named{"px", p.x}, Named{"py", p.y}, Named{"pw", p.z});
        const auto left = [&](int line, T x, T y) {
            const T f = p.x * x + p.y * y + p.z;
            return unsigned(asked(f >= T(0), line, s, Edge::None, watch, Named{"F", f}));
        };
        unsigned pattern = left(5, w.min.x, w.min.y);
        pattern |= left(6, w.max.x, w.min.y) << 1;
        pattern |= left(7, w.max.x, w.max.y) << 2;
        pattern |= left(8, w.min.x, w.max.y) << 3;
        const Crossing& edge = crossings[pattern];
        if (!isCrossed(edge, pattern, s, watch))
            return std::nullopt;
        BasicSegment<T> visible = s;
        const auto cut = [&](int line, glm::vec<2, T> BasicSegment<T>::*end, int k) {
            visible.*end = meet(p, k, w);
            watch("cut", line, visible, edges[static_cast<std::size_t>(k)]);
        };
        if (codeA != 0 && codeB != 0) {
            cut(16, &BasicSegment<T>::a, edge.tab1);
            cut(17, &BasicSegment<T>::b, edge.tab2);
        } else if (codeA == 0)
            cut(19, &BasicSegment<T>::b, codeB & edge.mask ? edge.tab1 : edge.tab2);
        else
            cut(21, &BasicSegment<T>::a, codeA & edge.mask ? edge.tab1 : edge.tab2);
        watch("accept", 22, visible, Edge::None);
        return visible;
    }

    /// Whether the table has edges for a pattern.
    template <class T, class Watch>
    static constexpr bool isCrossed(const Crossing& edge, unsigned pattern,
                                    const BasicSegment<T>& s, Watch& watch)
    {
        watch("row of the table", 13, s, Edge::None, Named{"c", static_cast<int>(pattern)},
              Named{"TAB1[c]", edge.tab1}, Named{"TAB2[c]", edge.tab2});
        if (!asked(edge.enter < 0, 14, s, Edge::None, watch))
            return true;
        watch("reject", 14, s, Edge::None);
        return false;
    }

    template <class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    crossedFromA(const BasicSegment<T>& s, const BasicWindow<T>& w, unsigned codeA, unsigned codeB,
                 Watch& watch)
    {
        // With the origin at a the line is dx * y = dy * x; the corners' products, and with them
        // the way along each edge, are all there is to know.
        const T dx = s.b.x - s.a.x, dy = s.b.y - s.a.y;
        const std::array products{dx * (w.min.y - s.a.y), dy * (w.max.x - s.a.x),
                                  dx * (w.max.y - s.a.y), dy * (w.min.x - s.a.x)};
        const auto& [bottom, right, top, left] = products;
        watch("line", 4, s, Edge::None, Named{"dx", dx}, Named{"dy", dy});
        const auto corner = [&](int line, bool held, T level, T side) {
            return unsigned(asked(held, line, s, Edge::None, watch, Named{"dx*(y-y1)", level},
                                  Named{"dy*(x-x1)", side}));
        };
        unsigned pattern = corner(5, bottom >= left, bottom, left);
        pattern |= corner(6, bottom >= right, bottom, right) << 1;
        pattern |= corner(7, top >= right, top, right) << 2;
        pattern |= corner(8, top >= left, top, left) << 3;
        const bool again = pattern == 15;
        if (again) {
            pattern = corner(9, bottom > left, bottom, left);
            pattern |= corner(10, bottom > right, bottom, right) << 1;
            pattern |= corner(11, top > right, top, right) << 2;
            pattern |= corner(12, top > left, top, left) << 3;
        }
        const bool onLine = again && pattern == 0; // the whole window, which has no area
        const Crossing& edge = onLine ? crossings[dx > T(0)   ? 12
                                                  : dx < T(0) ? 3
                                                  : dy > T(0) ? 9
                                                              : 6]
                                      : crossings[pattern];
        if (!isCrossed(edge, pattern, s, watch))
            return std::nullopt;
        const auto meetFromA = [&](int k) -> glm::vec<2, T> {
            const T product = products[static_cast<std::size_t>(k)];
            const glm::vec<2, T> at =
                k % 2 == 0 ? glm::vec<2, T>{s.a.x + product / dy, k == 0 ? w.min.y : w.max.y}
                           : glm::vec<2, T>{k == 1 ? w.max.x : w.min.x, s.a.y + product / dx};
            return clampedAlong(edges[static_cast<std::size_t>(k)], at, w);
        };
        BasicSegment<T> visible = s;
        const auto cut = [&](int line, glm::vec<2, T> BasicSegment<T>::*end, int k) {
            visible.*end = meetFromA(k);
            watch("cut", line, visible, edges[static_cast<std::size_t>(k)]);
        };
        if (codeA != 0)
            cut(codeB != 0 ? 16 : 21, &BasicSegment<T>::a, edge.enter);
        if (codeB != 0)
            cut(codeA != 0 ? 17 : 19, &BasicSegment<T>::b, edge.leave);
        watch("accept", 22, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<Skala>();

} // namespace clipping
