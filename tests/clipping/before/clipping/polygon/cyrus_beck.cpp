// SPDX-License-Identifier: MIT
//
// Cyrus-Beck (1978) against convex polygons, which is what it was made for;
// algorithms/cyrus_beck.cpp has the reference.
//
// The inner normal of an edge tells how deep each end lies inside it. The difference of the two
// depths is the authors' D, the speed along the normal; the signs are exact, so that an end that is
// inside is never cut, and D is never a quotient's zero.

#include "clipping/polygon/describe.h"

namespace clipping {
namespace {

struct CyrusBeckPolygon {
    static constexpr int rejectLine = 14, acceptLine = 19;

    /// A bound of what is visible: where on the segment, and the edge that says so.
    template <class T>
    struct Bound {
        T t;
        std::optional<std::size_t> edge;
    };

    /// The point at t, 0 to 1.
    template <class T>
    static glm::vec<2, T> at(T t, const BasicSegment<T>& s)
    {
        return t == T(1) ? s.b
                         : glm::vec<2, T>{s.a.x + t * (s.b.x - s.a.x), s.a.y + t * (s.b.y - s.a.y)};
    }

    /// Raises the entry and lowers the exit to where the segment is inside the sides of the box;
    /// false if it passes one side by. That matters at the tip of a needle, where two edges are
    /// nearly one line and the normals cannot tell where they meet.
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

    template <class T, class Watch>
    static std::optional<PolygonPiece<T>> clip(const BasicSegment<T>& s,
                                               const PolygonIn<T>& polygon, Watch&& watch)
    {
        Bound<T> entry{T(0), {}}, exit{T(1), {}};
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const auto from = polygon.corner(i), to = polygon.corner(polygon.after(i));
            const auto along = polygon.edge(i);
            const Cross<T> a = cross(along, from, to, from, s.a);
            const Cross<T> b = cross(along, from, to, from, s.b);
            const Named number{"edge", unsigned(polygon.number(i))};
            if (a.sign < 0 && b.sign < 0) {
                watch("reject", 6, s, Edge::None, number, Named{"N", a.value});
                return std::nullopt;
            }
            if (a.sign >= 0 && b.sign >= 0)
                continue;
            const T t = shareBefore(a, b);
            if (a.sign < 0) {
                if (!entry.edge || t > entry.t)
                    entry = {t, i};
                watch("entry", 11, s, Edge::None, number, Named{"N", a.value}, Named{"t", t});
            } else {
                if (!exit.edge || t < exit.t)
                    exit = {t, i};
                watch("exit", 13, s, Edge::None, number, Named{"N", a.value}, Named{"t", t});
            }
        }
        const auto box = polygon.box();
        const auto a = at(entry.t, s), b = at(exit.t, s);
        const bool outside = clamped(a, box) != a || clamped(b, box) != b;
        if ((outside && !holdIn(box, s, entry, exit)) || entry.t > exit.t) {
            watch("reject", 14, s, Edge::None, Named{"tE", entry.t}, Named{"tL", exit.t});
            return std::nullopt;
        }
        PolygonPiece<T> piece{s};
        if (exit.edge) {
            piece.segment.b = clamped(at(exit.t, s), box);
            piece.numberOfB = polygon.number(*exit.edge);
            watch("cut b", 16, piece.segment, Edge::None, Named{"tL", exit.t});
        }
        if (entry.edge) {
            const bool contact = exit.edge && entry.t == exit.t;
            piece.segment.a = contact ? piece.segment.b : clamped(at(entry.t, s), box);
            piece.numberOfA = polygon.number(*entry.edge);
            watch("cut a", 18, piece.segment, Edge::None, Named{"tE", entry.t});
        }
        watch("accept", 19, piece.segment, Edge::None);
        return piece;
    }
};

} // namespace

const Uses<Segment, ConvexPolygon> cyrusBeckPolygon = polygonUses<CyrusBeckPolygon>;

} // namespace clipping
