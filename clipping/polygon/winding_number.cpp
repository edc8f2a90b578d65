// SPDX-License-Identifier: MIT
//
// Winding number, for convex polygons: O(N), with the sides of all corners. It differs from the
// form for windows (algorithms/winding_number.cpp) in that the ends of the segment need orientation
// tests, too, and a new end is the point where two lines meet, each coordinate rounded once
// (exact/meeting.h). All decisions are exact. So the result is that of `exact`, bit for bit, edge
// numbers included: 1/2 ulp of the coordinate itself.
//
// Only edges that the line crosses have steps.

#include "clipping/ieee_numbers.h"
#include "clipping/polygon/describe.h"
#include "clipping/polygon/exact_ends.h"

namespace clipping {
namespace {

struct WindingNumberPolygon : ExactEnds {
    static constexpr std::string_view rejected = "reject";
    static constexpr bool unframed = true; // it handles all finite numbers itself

    /// The winding number at the first visible point, and the edges that cut the ends.
    struct Count {
        int w = 0;
        std::optional<std::size_t> enter, leave;
    };

    /// The largest side of a corner: 1 as soon as one is left of the line.
    template <class T>
    static int leftmost(const OrientedLine<T>& line, const PolygonIn<T>& polygon)
    {
        int left = -1;
        for (std::size_t i = 0; i < polygon.size() && left < 1; ++i)
            left = std::max(left, line.leftOf(polygon.corner(i)).sign);
        return left;
    }

    /// Counts an edge that the line crosses.
    template <class T, class Step>
    static void pass(Count& count, std::size_t i, bool isEntry, const BasicSegment<T>& s,
                     const PolygonIn<T>& polygon, Step& step)
    {
        step.set("i", int(polygon.number(i)));
        const bool endIsBeyond = sideOf(s.b, i, polygon) < 0;
        if (isEntry) {
            if (!step.test("enters", !endIsBeyond))
                return;
            count.w = step.let("countUp", "w", count.w + 1);
            if (step.test("end1", sideOf(s.a, i, polygon) < 0))
                count.enter = i;
        } else if (step.test("leaves", endIsBeyond)) {
            if (step.test("notEntered", sideOf(s.a, i, polygon) < 0))
                count.w = step.let("countDown", "w", count.w - 1);
            else
                count.leave = i;
        }
    }

    template <class T, class Step>
    static Count countAlong(const OrientedLine<T>& line, const PolygonIn<T>& polygon, Step& step)
    {
        const int left = step.let("most", "most", leftmost(line, polygon));
        Count count;
        const std::size_t last = polygon.size() - 1;
        bool wasLeft = line.leftOf(polygon.corner(last)).sign == left;
        for (std::size_t i = 0, edge = last; i <= last; edge = i++) {
            const bool isLeft = line.leftOf(polygon.corner(i)).sign == left;
            if (isLeft != wasLeft)
                pass(count, edge, wasLeft, line.s, polygon, step);
            wasLeft = isLeft;
        }
        return count;
    }

    template <class T, class Step>
    static std::optional<PolygonPiece<T>> clip(const BasicSegment<T>& s,
                                               const PolygonIn<T>& polygon, Step&& step)
    {
        const auto [min, max] = polygon.box();
        if (step.test("besideX",
                      (s.a.x < min.x && s.b.x < min.x) || (s.a.x > max.x && s.b.x > max.x),
                      Edge::Left, Edge::Right))
            return step.reject("rejectX");
        if (step.test("besideY",
                      (s.a.y < min.y && s.b.y < min.y) || (s.a.y > max.y && s.b.y > max.y),
                      Edge::Bottom, Edge::Top))
            return step.reject("rejectY");
        const OrientedLine<T> line(s);
        const Count count = countAlong(line, polygon, step);
        if (step.test("missed", count.w == 0))
            return step.reject("reject");
        PolygonPiece<T> piece{s};
        // If a segment only reaches an edge, both new ends are the end that reaches it.
        if (count.enter) {
            const auto end = endOn(*count.enter, line, polygon);
            piece.segment.a = sideOf(s.b, *count.enter, polygon) == 0 ? s.b : end.at;
            piece.numberOfA = end.number;
            step.cut("move1", 0, piece.segment.a, Edge::NoEdge);
        }
        if (count.leave) {
            const auto end = endOn(*count.leave, line, polygon);
            piece.segment.b = sideOf(s.a, *count.leave, polygon) == 0 ? s.a : end.at;
            piece.numberOfB = end.number;
            step.cut("move2", 1, piece.segment.b, Edge::NoEdge);
        }
        step.accept("accept", piece.segment);
        return piece;
    }
};

} // namespace

const Functions<Segment, ConvexPolygon> windingNumberPolygon = polygonUses<WindingNumberPolygon>;

} // namespace clipping
