// SPDX-License-Identifier: MIT
//
// Skala (2005) for convex polygons: the sides of the segment's line on which the corners lie
// determine the two edges that the line crosses (crossed.h).
//
// All signs are exact, so visibility is never wrong. As with windows, a line without a corner
// strictly on its left is tested again with "on it" counting as "left". Steps have the line numbers
// of the corrected pseudo-code for windows (algorithms/skala.cpp).

#include "clipping/ieee_numbers.h"
#include "clipping/polygon/crossed.h"
#include "clipping/polygon/describe.h"

namespace clipping {
namespace {

template <class Search>
struct SkalaPolygon {
    static constexpr int rejectLine = 23, acceptLine = 29;

    template <class T>
    static glm::vec<2, T> meet(const OrientedLine<T>& line, std::size_t i,
                               const PolygonIn<T>& polygon)
    {
        const BasicSegment<T> edge{polygon.corner(i), polygon.corner(polygon.after(i))};
        return meetOnEdge(edge, line.leftOf(edge.a), line.leftOf(edge.b), line.s);
    }

    template <class T, class Step>
    static std::optional<PolygonPiece<T>> clip(const BasicSegment<T>& s,
                                               const PolygonIn<T>& polygon, Step&& step)
    {
        const OrientedLine<T> line(s);
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
            step.cut(28, 0, piece.segment.a, Edge::NoEdge);
        }
        if (step.test(25, sideOf(s.b, leave, polygon) < 0)) {
            piece.segment.b = aLeaves == 0 ? s.a : meet(line, leave, polygon);
            piece.numberOfB = polygon.number(leave);
            step.cut(26, 1, piece.segment.b, Edge::NoEdge);
        }
        step.accept(acceptLine, piece.segment);
        return piece;
    }
};

} // namespace

const Functions<Segment, ConvexPolygon> skalaPolygon = polygonUses<SkalaPolygon<OneByOne>>;
const Functions<Segment, ConvexPolygon> skalaSearchedPolygon = polygonUses<SkalaPolygon<Searched>>;

} // namespace clipping
