// SPDX-License-Identifier: MIT
//
// Cyrus-Beck (1978) for convex polygons, the case it was designed for; algorithms/cyrus_beck.cpp
// has the reference.
//
// The inner normal of an edge gives the depth of each end inside the edge. The difference of the
// two depths is the authors' D, the speed along the normal. The signs of the depths are exact, so
// an end that is inside is never cut and no quotient has D = 0.

#include "clipping/ieee_numbers.h"
#include "clipping/polygon/describe.h"

namespace clipping {
namespace {

struct CyrusBeckPolygon {
    static constexpr std::string_view rejected = "missed";

    /// A bound of the visible part: its parameter on the segment, and the edge that set it.
    template <class T>
    struct Bound {
        T t;
        std::optional<std::size_t> edge;
    };
    template <class T>
    struct Interval {
        Bound<T> entry, exit;
    };

    /// The point at t, 0 to 1.
    template <class T>
    static glm::vec<2, T> at(T t, const BasicSegment<T>& s)
    {
        return t == T(1) ? s.b
                         : glm::vec<2, T>{s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)};
    }

    /// Raises the entry and lowers the exit to the part of the segment inside the box; false if
    /// there is none. This matters at the tip of a very thin polygon, where two edges are nearly
    /// parallel and their normals do not determine where they meet.
    template <class T>
    static bool holdIn(const BasicWindow<T>& box, const BasicSegment<T>& s, Bound<T>& entry,
                       Bound<T>& exit)
    {
        for (int axis = 0; axis < 2; ++axis) {
            const T from = s.a[axis], d = s.b[axis] - from;
            const T near = d < T(0) ? box.max[axis] : box.min[axis];
            const T far = d < T(0) ? box.min[axis] : box.max[axis];
            if (d == T(0)) {
                if (from < near || from > far)
                    return false;
                continue;
            }
            const T in = (near - from) / d, out = (far - from) / d;
            if (entry.edge && in > entry.t)
                entry.t = in;
            if (exit.edge && out < exit.t)
                exit.t = out;
        }
        return true;
    }

    /// Cuts at one edge; called for the edges in order around the polygon. Returns false if both
    /// ends are outside the edge.
    template <class T, class Step>
    static bool cutAt(std::size_t i, const BasicSegment<T>& s, const PolygonIn<T>& polygon,
                      Interval<T>& part, Step& step)
    {
        auto& [entry, exit] = part;
        const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
        const auto along = polygon.edge(i);
        const Cross<T> a = cross(along, from, to, from, s.a);
        const Cross<T> b = cross(along, from, to, from, s.b);
        step.set("edge", int(polygon.number(i))), step.let("N", "N", a.value);
        if (step.test("outside", a.sign < 0 && b.sign < 0)) {
            step.reject("outside");
            return false;
        }
        if (a.sign >= 0 && b.sign >= 0)
            return true;
        const T t = step.let("t", "t", shareBefore(a, b));
        if (step.test("entering", a.sign < 0)) {
            if (step.test("later", !entry.edge || t > entry.t))
                entry = {step.let("start", "tE", t), i};
        } else if (step.test("sooner", !exit.edge || t < exit.t))
            exit = {step.let("stop", "tL", t), i};
        return true;
    }

    template <class T, class Step>
    static std::optional<PolygonPiece<T>> clip(const BasicSegment<T>& s,
                                               const PolygonIn<T>& polygon, Step&& step)
    {
        Interval<T> part{{step.set("tE", T(0)), {}}, {step.set("tL", T(1)), {}}};
        auto& [entry, exit] = part;
        for (std::size_t i = 0; i < polygon.size(); ++i)
            if (!cutAt(i, s, polygon, part, step))
                return std::nullopt;
        const auto box = polygon.box();
        const auto a = at(entry.t, s), b = at(exit.t, s);
        const bool outside = clamped(a, box) != a || clamped(b, box) != b;
        const bool missed = outside && !holdIn(box, s, entry, exit);
        step.set("tE", entry.t), step.set("tL", exit.t);
        if (step.test("missed", missed || entry.t > exit.t))
            return step.reject("missed");
        PolygonPiece<T> piece{s};
        if (exit.edge) {
            piece.segment.b = clamped(at(exit.t, s), box);
            piece.numberOfB = polygon.number(*exit.edge);
            step.cut("move2", 1, piece.segment.b, Edge::NoEdge);
        }
        if (entry.edge) {
            const bool contact = exit.edge && entry.t == exit.t;
            piece.segment.a = contact ? piece.segment.b : clamped(at(entry.t, s), box);
            piece.numberOfA = polygon.number(*entry.edge);
            step.cut(contact ? "contact" : "move1", 0, piece.segment.a, Edge::NoEdge);
        }
        step.accept("accept", piece.segment);
        return piece;
    }
};

} // namespace

const Functions<Segment, ConvexPolygon> cyrusBeckPolygon = polygonUses<CyrusBeckPolygon>;

} // namespace clipping
