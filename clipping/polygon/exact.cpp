// SPDX-License-Identifier: MIT
//
// Exact, for convex polygons: no wrong decision on any finite input, and every coordinate of a new
// end is that of the point where the lines of segment and edge meet, rounded once. So the result is
// unique: it depends neither on the order of the ends, nor on the instruction set, nor on how the
// crossed edges are found. Rounding keeps the order of numbers, so a new end is inside the bounding
// boxes of polygon and segment, and bit for bit on a horizontal or vertical edge. It is within half
// an ulp of its own coordinate, hence within half an ulp of M, of a point of the edge.
//
// The line enters through the edge from a corner on its left to one that is not, and leaves through
// the edge back (crossed.h). What is visible lies between the two: nothing, if b is beyond the edge
// of entry or a beyond that of exit. If the line passes through a corner, the new end is that
// corner, with the number of the edge that begins there; a rule that does not depend on the
// direction.

#include "clipping/batch/kernels.h"
#include "clipping/batch/sets.h"
#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"
#include "clipping/polygon/crossed.h"
#include "clipping/polygon/describe.h"
#include "clipping/polygon/edge_table.h"
#include "clipping/polygon/exact_ends.h"

namespace clipping {
namespace {

std::size_t clipAllInPolygon(std::span<const Segment> in, const ConvexPolygon& polygon,
                             std::span<Clipped> out);

template <class Search>
struct ExactPolygon : ExactEnds {
    static constexpr std::string_view rejected = "reject";
    static constexpr bool unframed = true; // it handles all finite numbers itself
    static constexpr auto many = clipAllInPolygon;

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
        const auto crossed = Search::crossed(line, polygon);
        if (step.test("missed", !crossed))
            return step.reject("reject");
        const auto [enter, leave] = *crossed;
        step.let("enter", "enter", int(polygon.number(enter)));
        step.let("leave", "leave", int(polygon.number(leave)));
        const int bEnters = sideOf(s.b, enter, polygon);
        const int aLeaves = bEnters < 0 ? -1 : sideOf(s.a, leave, polygon);
        if (step.test("beyond", bEnters < 0 || aLeaves < 0))
            return step.reject("rejectBeyond");
        PolygonPiece<T> piece{s};
        if (step.test("end1", sideOf(s.a, enter, polygon) < 0)) {
            const auto end = endOn(enter, line, polygon);
            piece.segment.a = bEnters == 0 ? s.b : end.at;
            piece.numberOfA = end.number;
            step.cut("move1", 0, piece.segment.a, Edge::NoEdge);
        }
        if (step.test("end2", sideOf(s.b, leave, polygon) < 0)) {
            const auto end = endOn(leave, line, polygon);
            piece.segment.b = aLeaves == 0 ? s.a : end.at;
            piece.numberOfB = end.number;
            step.cut("move2", 1, piece.segment.b, Edge::NoEdge);
        }
        step.accept("accept", piece.segment);
        return piece;
    }
};

/// From so many segments on, the vector kernel's tables are worth their preparation.
constexpr std::size_t fewest = 32;

std::size_t clipAllInPolygon(std::span<const Segment> in, const ConvexPolygon& polygon,
                             std::span<Clipped> out)
{
    requireRoom(in.size(), out.size());
    const auto window = prepared(polygon);
    if (!window)
        return 0;
    if (in.size() >= fewest && !window->flat && window->ordinary) {
        const EdgeTable table(*window);
        return clipBatch({in.data(), 0, in.size(), &*window, &table.table(), out.data()}).pieces;
    }
    std::size_t visible = 0;
    for (std::uint32_t i = 0; i < in.size(); ++i)
        visible += clipOneByOne(in.data(), &i, 1, *window, out.data() + visible);
    return visible;
}

} // namespace

std::size_t clipOneByOne(const Segment* segments, const std::uint32_t* indices, std::size_t count,
                         const PreparedPolygon& polygon, Clipped* out)
{
    using Method = ExactPolygon<Searched>;
    std::size_t visible = 0;
    for (std::size_t i = 0; i < count; ++i)
        if (const auto piece = clipPrepared<Method>(segments[indices[i]], polygon))
            out[visible++] = {piece->segment, indices[i],
                              polygonCutAt(piece->numberOfA, piece->numberOfB)};
    return visible;
}

const Functions<Segment, ConvexPolygon> exactPolygon = polygonUses<ExactPolygon<OneByOne>>;
const Functions<Segment, ConvexPolygon> exactSearchedPolygon = polygonUses<ExactPolygon<Searched>>;

} // namespace clipping
