// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/turn.h"
#include "clipping/polygon/prepared.h"

#include <optional>

// Finds the two edges of a polygon that a line crosses, by the side of the line on which the
// corners lie. All signs are exact. Two ways, with the same result:
//
//   one by one   O(N): the signs of all corners, as Skala (2005) does with a window's four.
//   searched     O(log N), in the spirit of V. Skala: O(lg N) Line Clipping Algorithm in E2.
//                Computers & Graphics 18(4), 1994, 517-524. The corners furthest to the line's left
//                and right are where the sorted directions of the edges pass the line's direction;
//                between these two corners the sign changes once on each side.

namespace clipping {

/// The edges at which a line enters a polygon and leaves it: if a corner is strictly on the line's
/// left, from such a corner to one that is not, and back; else from a corner on the line to one
/// strictly on its right, and back.
struct Crossed {
    std::size_t enter, leave;
};

/// The directed line of a segment; for a single point, the horizontal line to the right.
template <class T>
struct OrientedLine {
    BasicSegment<T> s;
    glm::vec<2, T> along;
    bool isPoint;

    explicit OrientedLine(const BasicSegment<T>& segment)
        : s(segment), along{s.b.x - s.a.x, s.b.y - s.a.y}, isPoint(s.a == s.b)
    {
    }
    static int signOf(T here, T there) { return here < there ? 1 : there < here ? -1 : 0; }

    /// The cross product of p: positive if p is left of the line.
    Cross<T> leftOf(const glm::vec<2, T>& p) const
    {
        return isPoint ? Cross<T>{T(0), signOf(s.a.y, p.y)} : cross(along, s.a, s.b, s.a, p);
    }
    /// The side to which the direction from p to q turns from the line's: 1 left, 0 parallel, -1
    /// right.
    int turnOf(const glm::vec<2, T>& p, const glm::vec<2, T>& q) const
    {
        return isPoint ? signOf(p.y, q.y) : cross(along, s.a, s.b, p, q).sign;
    }
    /// Whether the direction is at least 0 and less than 180 degrees.
    bool isUpwards() const { return isPoint || upwards(s.a, s.b); }
    static bool upwards(const glm::vec<2, T>& p, const glm::vec<2, T>& q)
    {
        return p.y < q.y || (p.y == q.y && p.x < q.x);
    }
};

struct OneByOne {
    template <class T>
    static std::optional<Crossed> crossed(const OrientedLine<T>& line, const PolygonIn<T>& polygon)
    {
        std::optional<std::size_t> enter, leave, enterClosed, leaveClosed;
        const std::size_t last = polygon.size() - 1;
        int before = line.leftOf(polygon.corner(last)).sign;
        for (std::size_t i = 0, edge = last; i <= last; edge = i++) {
            const int sign = line.leftOf(polygon.corner(i)).sign;
            if (before > 0 && sign <= 0)
                enter = edge;
            if (before <= 0 && sign > 0)
                leave = edge;
            if (before >= 0 && sign < 0)
                enterClosed = edge;
            if (before < 0 && sign >= 0)
                leaveClosed = edge;
            before = sign;
        }
        if (enter)
            return Crossed{*enter, *leave};
        if (before > 0 || !enterClosed) // all corners are on one side
            return std::nullopt;
        return Crossed{*enterClosed, *leaveClosed};
    }
};

struct Searched {
    /// The first index below `count` for which `is` holds, if it also holds for all later ones;
    /// binary search.
    static std::size_t first(std::size_t count, auto is)
    {
        std::size_t low = 0, high = count;
        while (low < high) {
            const std::size_t middle = (low + high) / 2;
            if (is(middle))
                high = middle;
            else
                low = middle + 1;
        }
        return low;
    }

    /// The corner furthest to the right of the line (side 1) or to its left (-1): the start of the
    /// first edge whose direction has reached that of the line, or the opposite one.
    template <class T>
    static std::size_t furthest(int side, const OrientedLine<T>& line, const PolygonIn<T>& polygon)
    {
        const bool up = (side > 0) == line.isUpwards();
        const std::size_t edge = first(polygon.size(), [&](std::size_t i) {
            const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
            const bool edgeUp = OrientedLine<T>::upwards(from, to);
            return edgeUp != up ? up : side * line.turnOf(from, to) >= 0;
        });
        return edge == polygon.size() ? 0 : edge;
    }

    template <class T>
    static std::optional<Crossed> crossed(const OrientedLine<T>& line, const PolygonIn<T>& polygon)
    {
        const std::size_t n = polygon.size();
        const std::size_t right = furthest(1, line, polygon), left = furthest(-1, line, polygon);
        const int most = line.leftOf(polygon.corner(left)).sign;
        const int least = line.leftOf(polygon.corner(right)).sign;
        if (most < 0 || least > 0)
            return std::nullopt;
        const auto isLeft = [&](std::size_t i) {
            const int sign = line.leftOf(polygon.corner(i % n)).sign;
            return most > 0 ? sign > 0 : sign >= 0;
        };
        const std::size_t falling = (right + n - left) % n, rising = n - falling;
        return Crossed{
            (left + first(falling, [&](std::size_t i) { return !isLeft(left + i); }) + n - 1) % n,
            (right + first(rising, [&](std::size_t i) { return isLeft(right + i); }) + n - 1) % n};
    }
};

/// 1 if p is on the inner side of edge i, 0 if p is on the edge's line, -1 if p is outside.
template <class T>
int sideOf(const glm::vec<2, T>& p, std::size_t i, const PolygonIn<T>& polygon)
{
    const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
    return cross(polygon.edge(i), from, to, from, p).sign;
}

} // namespace clipping
