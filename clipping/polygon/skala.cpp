// SPDX-License-Identifier: MIT
//
// Skala (2005) for convex polygons: the sides of the segment's line on which the corners lie
// determine the two edges that the line crosses. Two ways find these edges, with the same result
// bit for bit:
//
//   one by one   O(N): the signs of all corners, as the paper does with a window's four.
//   searched     O(log N), in the spirit of V. Skala: O(lg N) Line Clipping Algorithm in E2.
//                Computers & Graphics 18(4), 1994, 517-524. The corners furthest to the line's left
//                and right are where the sorted directions of the edges pass the line's direction;
//                between these two corners the sign changes once on each side.
//
// All signs are exact, so visibility is never wrong. As with windows, a line without a corner
// strictly on its left is tested again with "on it" counting as "left". Steps have the line numbers
// of the corrected pseudo-code for windows (algorithms/skala.cpp).

#include "clipping/ieee_numbers.h"
#include "clipping/polygon/describe.h"

namespace clipping {
namespace {

/// The edges at which a line enters a polygon and leaves it.
struct Crossed {
    std::size_t enter, leave;
};

/// The directed line of a segment; for a single point, the horizontal line to the right.
template <class T>
struct DirectedLine {
    BasicSegment<T> s;
    glm::vec<2, T> along;
    bool isPoint;

    explicit DirectedLine(const BasicSegment<T>& segment)
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
    static std::optional<Crossed> crossed(const DirectedLine<T>& line, const PolygonIn<T>& polygon)
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
    static std::size_t furthest(int side, const DirectedLine<T>& line, const PolygonIn<T>& polygon)
    {
        const bool up = (side > 0) == line.isUpwards();
        const std::size_t edge = first(polygon.size(), [&](std::size_t i) {
            const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
            const bool edgeUp = DirectedLine<T>::upwards(from, to);
            return edgeUp != up ? up : side * line.turnOf(from, to) >= 0;
        });
        return edge == polygon.size() ? 0 : edge;
    }

    template <class T>
    static std::optional<Crossed> crossed(const DirectedLine<T>& line, const PolygonIn<T>& polygon)
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

template <class Search>
struct SkalaPolygon {
    static constexpr int rejectLine = 23, acceptLine = 29;

    /// 1 if p is on the inner side of edge i, 0 if p is on the edge's line, -1 if p is outside.
    template <class T>
    static int sideOf(const glm::vec<2, T>& p, std::size_t i, const PolygonIn<T>& polygon)
    {
        const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
        return cross(polygon.edge(i), from, to, from, p).sign;
    }

    template <class T>
    static glm::vec<2, T> meet(const DirectedLine<T>& line, std::size_t i,
                               const PolygonIn<T>& polygon)
    {
        const BasicSegment<T> edge{polygon.corner(i), polygon.corner(polygon.after(i))};
        return meetOnEdge(edge, line.leftOf(edge.a), line.leftOf(edge.b), line.s);
    }

    template <class T, class Step>
    static std::optional<PolygonPiece<T>> clip(const BasicSegment<T>& s,
                                               const PolygonIn<T>& polygon, Step&& step)
    {
        const DirectedLine<T> line(s);
        const auto crossed = Search::crossed(line, polygon);
        if (step.test(22, !crossed))
            return step.reject(rejectLine);
        const auto [enter, leave] = *crossed;
        step.set("i", int(polygon.number(enter))), step.let(24, "j", int(polygon.number(leave)));
        const int bEnters = sideOf(s.b, enter, polygon);
        const int aLeaves = bEnters < 0 ? -1 : sideOf(s.a, leave, polygon);
        if (step.test(4, bEnters < 0 || aLeaves < 0))
            return step.reject(5);
        PolygonPiece<T> piece{s};
        // If a segment only reaches an edge, both new ends are the end that reaches it.
        if (step.test(27, sideOf(s.a, enter, polygon) < 0)) {
            piece.segment.a = bEnters == 0 ? s.b : meet(line, enter, polygon);
            piece.numberOfA = polygon.number(enter);
            step.cut(28, 0, piece.segment.a, Edge::None);
        }
        if (step.test(25, sideOf(s.b, leave, polygon) < 0)) {
            piece.segment.b = aLeaves == 0 ? s.a : meet(line, leave, polygon);
            piece.numberOfB = polygon.number(leave);
            step.cut(26, 1, piece.segment.b, Edge::None);
        }
        step.accept(acceptLine, piece.segment);
        return piece;
    }
};

} // namespace

const Uses<Segment, ConvexPolygon> skalaPolygon = polygonUses<SkalaPolygon<OneByOne>>;
const Uses<Segment, ConvexPolygon> skalaSearchedPolygon = polygonUses<SkalaPolygon<Searched>>;

} // namespace clipping
