// SPDX-License-Identifier: MIT
//
// Slater-Barsky (1994).
//
//   M. Slater, B. A. Barsky: 2D Line and Polygon Clipping Based on Space Subdivision.
//   The Visual Computer 10, 1994, 407-422.
//
// Published is the form that the program EnergyPlus made of it; we have seen only parts of the
// paper. Corrected: a segment along an axis has its ends held inside the window, so that nothing is
// divided by 0; a tie at a corner goes towards the window; the sign of the rise is asked once; a
// new end is held inside the window on the side where rounding may have left it outside.
//
// How far off. Let e = 2^-53 and M as in README.md. In units of dx*dy the error term is a sum of
// parameters, t(x) - t(y), of which those that are visible or compared lie between 0 and 1: two
// products that start it, one for each step to another cell, two such steps before the last
// question. Each product is off by 3e of itself, and they add up to t(x) + t(y) <= 2: 6e; three
// sums of at most 1 are off by e each: 9e in all. A wrong decision therefore needs two points of
// the segment that are 9e*D apart, D <= 2M being its extent: 18 units. A new end is off by the
// same, by the quotient's rounding (2 units, for it is no longer than 2M) and by that of the last
// sum (1): 21 units. Both together are 39, and 40 leaves one for terms of second order.

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/ieee_numbers.h"

#include <compare>

namespace clipping {

struct SlaterBarsky {
    static constexpr About about{
        .key = "slater-barsky",
        .abbreviation = "SB",
        .name = "Slater-Barsky",
        .year = 1994,
        .idea = "Walk along the segment from one of nine cells to the next, and let an error term "
                "tell by which side it leaves.",
        .ulps = 40,
    };

    /// Where the walk is: column 0 is left of the window and 1 above, in or below it; row 0 is
    /// below, 1 beside or in, 2 above. There is nothing to find further right.
    struct Cell {
        int column, row;
        constexpr bool centre() const { return column == 1 && row == 1; }
        constexpr int number() const { return 3 * row + column; }
        /// The edge in whose line the side lies that the segment leaves the cell by.
        constexpr Edge side(bool right, bool up) const
        {
            return right      ? column == 0 ? Edge::Left : Edge::Right
                   : up       ? row == 0 ? Edge::Bottom : Edge::Top
                   : row == 2 ? Edge::Top
                              : Edge::Bottom;
        }
    };

    /// Shows a watcher what happens to a segment that was turned round as it was given.
    template <class Watch>
    struct ReversedWatch {
        Watch& watch;
        void operator()(std::string_view what, int line, const auto& s, Edge edge,
                        const auto&... values) const
        {
            auto given = s;
            std::swap(given.a, given.b);
            watch(what, line, given, edge, values...);
        }
    };
    template <class Watch>
    static constexpr auto reversedWatch(Watch& watch)
    {
        if constexpr (std::is_same_v<std::remove_cv_t<Watch>, Unwatched>)
            return Unwatched{};
        else
            return ReversedWatch<Watch>{watch};
    }

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        if (!asked(s.a.x > s.b.x, 1, s, Edge::None, watch))
            return rightwards<form>(s, w, watch);
        watch("swap", 2, s, Edge::None);
        auto reversed = reversedWatch(watch);
        const auto piece = rightwards<form>(BasicSegment<T>{s.b, s.a}, w, reversed);
        if (!piece)
            return std::nullopt;
        return BasicSegment<T>{piece->b, piece->a};
    }

    /// Clips a segment that does not go left.
    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    rightwards(const BasicSegment<T>& s, const BasicWindow<T>& w, Watch& watch)
    {
        const auto& [a, b] = s;
        const auto cell = cellOfA(s, w, watch);
        if (!cell)
            return std::nullopt;
        watch("cell", 13, s, Edge::None, Named{"cell", cell->number()});
        if (asked(cell->centre() && b.x <= w.max.x && b.y >= w.min.y && b.y <= w.max.y, 14, s,
                  Edge::None, watch)) {
            watch("accept", 14, s, Edge::None);
            return s;
        }
        const glm::vec<2, T> d{b.x - a.x, b.y - a.y};
        watch("dx, dy", 15, s, Edge::None, Named{"dx", d.x}, Named{"dy", d.y});
        if constexpr (form == Form::Published)
            return walk<form>(s, w, *cell, d, watch, [&] { return d.y > T(0); });
        const auto rise = d.y <=> T(0);
        if (asked(d.x == T(0) || std::is_eq(rise), 16, s, Edge::None, watch)) {
            const BasicSegment<T> visible{clamped(a, w), clamped(b, w)};
            watch("cut both", 17, visible, Edge::None);
            watch("accept", 17, visible, Edge::None);
            return visible;
        }
        return walk<form>(s, w, *cell, d, watch, [&] { return std::is_gt(rise); });
    }

    /// The cell that a lies in; nothing if both ends are beyond one edge.
    template <class T, class Watch>
    static constexpr std::optional<Cell> cellOfA(const BasicSegment<T>& s, const BasicWindow<T>& w,
                                                 Watch& watch)
    {
        const auto ask = [&](bool held, int line, Edge edge) {
            return asked(held, line, s, edge, watch);
        };
        const auto reject = [&](int line, Edge edge) {
            watch("reject", line, s, edge);
            return std::nullopt;
        };
        if (ask(s.a.x > w.max.x, 3, Edge::Right))
            return reject(3, Edge::Right);
        if (ask(s.b.x < w.min.x, 4, Edge::Left))
            return reject(4, Edge::Left);
        const int column = ask(s.a.x < w.min.x, 5, Edge::Left) ? 0 : 1;
        if (ask(s.a.y < w.min.y, 7, Edge::Bottom)) {
            if (ask(s.b.y < w.min.y, 8, Edge::Bottom))
                return reject(8, Edge::Bottom);
            return Cell{column, 0};
        }
        if (ask(s.a.y > w.max.y, 10, Edge::Top)) {
            if (ask(s.b.y > w.max.y, 11, Edge::Top))
                return reject(11, Edge::Top);
            return Cell{column, 2};
        }
        return Cell{column, 1};
    }

    /// From cell to cell. `rising` says whether the segment rises; as published, each asking costs.
    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>>
    walk(const BasicSegment<T>& s, const BasicWindow<T>& w, Cell cell, const glm::vec<2, T>& d,
         Watch& watch, auto rising)
    {
        BasicSegment<T> visible = s;
        const bool toTop = cell.row == 2 || (cell.row == 1 && rising());
        T e = d.y * ((cell.column == 0 ? w.min.x : w.max.x) - s.a.x)
              + d.x * (s.a.y - (toTop ? w.max.y : w.min.y));
        watch("e", 20, visible, Edge::None, Named{"e", e});
        for (;;) {
            const bool up = rising(), right = leavesRight<form>(e <=> T(0), up, cell);
            const Edge side = cell.side(right, up);
            asked(right, up ? 22 : 23, visible, side, watch, Named{"e", e});
            if (cell.centre()) {
                visible.b = right ? atSide<form>(up, w.max.x, e, d, w)
                                  : atHeight<form>(up ? w.max.y : w.min.y, e, d, w);
                watch("cut", right ? 25 : 26, visible, side);
                break;
            }
            const Cell next =
                right ? Cell{1, cell.row} : Cell{cell.column, up ? cell.row + 1 : cell.row - 1};
            if ((right && cell.column == 1) || next.row < 0 || next.row > 2
                || (!right && cell.row == 1)) {
                watch("reject", 27, visible, side);
                return std::nullopt;
            }
            if (next.centre()) {
                visible.a = right ? atSide<form>(up, w.min.x, e, d, w)
                                  : atHeight<form>(up ? w.min.y : w.max.y, e, d, w);
                watch("cut", right ? 29 : 30, visible, side);
                if (asked(s.b.x <= w.max.x && (up ? s.b.y <= w.max.y : s.b.y >= w.min.y), 31,
                          visible, Edge::None, watch))
                    break;
            }
            if (right)
                e += d.y * (w.max.x - w.min.x);
            else if (up)
                e -= d.x * (w.max.y - w.min.y);
            else
                e += d.x * (w.max.y - w.min.y);
            cell = next;
            watch("next cell",
                  right ? 32
                  : up  ? 33
                        : 34,
                  visible, side, Named{"cell", cell.number()}, Named{"e", e});
        }
        watch("accept", 36, visible, Edge::None);
        return visible;
    }

    /// By which side the segment leaves a cell: right, or else up or down. A tie is a corner of the
    /// window; corrected, it leads into the window, or out of it upwards or downwards.
    template <Form form>
    static constexpr bool leavesRight(auto sign, bool rising, Cell cell)
    {
        if (form == Form::Corrected && std::is_eq(sign))
            return cell.column == 0;
        return rising ? std::is_lt(sign) : std::is_gteq(sign);
    }

    /// Where the segment meets the left or right edge. The error term tells how far that is from
    /// the top edge, when rising, or the bottom one: it cannot be beyond that.
    template <Form form, class T>
    static constexpr glm::vec<2, T> atSide(bool rising, T x, T e, const glm::vec<2, T>& d,
                                           const BasicWindow<T>& w)
    {
        const T y = (rising ? w.max.y : w.min.y) + e / d.x;
        if constexpr (form == Form::Published)
            return {x, y};
        else if (rising)
            return {x, y < w.min.y ? w.min.y : y};
        else
            return {x, y > w.max.y ? w.max.y : y};
    }

    /// Where it meets the bottom or top edge, not beyond the right one.
    template <Form form, class T>
    static constexpr glm::vec<2, T> atHeight(T y, T e, const glm::vec<2, T>& d,
                                             const BasicWindow<T>& w)
    {
        const T x = w.max.x - e / d.y;
        return {form == Form::Corrected && x < w.min.x ? w.min.x : x, y};
    }
};

template Algorithm describe<SlaterBarsky>();

} // namespace clipping
