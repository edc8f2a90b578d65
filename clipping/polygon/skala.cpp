// SPDX-License-Identifier: MIT
//
// Skala (2005) for convex polygons: the sides of the segment's line on which the corners lie
// determine the two edges that the line crosses (crossed.h).
//
// All signs are exact, so visibility is never wrong. As with windows, a line without a corner
// strictly on its left is tested again with "on it" counting as "left".

#include "clipping/ieee_numbers.h"
#include "clipping/polygon/crossed.h"
#include "clipping/polygon/describe.h"

namespace clipping {
namespace {

template <class Search>
struct SkalaPolygon {
    static constexpr std::string_view rejected = "reject";

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
        if (step.test("missed", !crossed))
            return step.reject("reject");
        const auto [enter, leave] = *crossed;
        step.set("i", int(polygon.number(enter))),
            step.let("edges", "j", int(polygon.number(leave)));
        const int bEnters = sideOf(s.b, enter, polygon);
        const int aLeaves = bEnters < 0 ? -1 : sideOf(s.a, leave, polygon);
        if (step.test("beyond", bEnters < 0 || aLeaves < 0))
            return step.reject("rejectBeyond");
        PolygonPiece<T> piece{s};
        // If a segment only reaches an edge, both new ends are the end that reaches it.
        if (step.test("end1", sideOf(s.a, enter, polygon) < 0)) {
            piece.segment.a = bEnters == 0 ? s.b : meet(line, enter, polygon);
            piece.numberOfA = polygon.number(enter);
            step.cut("move1", 0, piece.segment.a, Edge::NoEdge);
        }
        if (step.test("end2", sideOf(s.b, leave, polygon) < 0)) {
            piece.segment.b = aLeaves == 0 ? s.a : meet(line, leave, polygon);
            piece.numberOfB = polygon.number(leave);
            step.cut("move2", 1, piece.segment.b, Edge::NoEdge);
        }
        step.accept("accept", piece.segment);
        return piece;
    }
};

} // namespace

const Functions<Segment, ConvexPolygon> skalaPolygon = polygonUses<SkalaPolygon<OneByOne>>;
const Functions<Segment, ConvexPolygon> skalaSearchedPolygon = polygonUses<SkalaPolygon<Searched>>;

} // namespace clipping
