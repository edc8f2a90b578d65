// SPDX-License-Identifier: MIT
//
// Cyrus-Beck in three dimensions, where the paper's convex polyhedron is the box: as in the plane,
// with planes for edges. The lines of the steps are those of the pseudo-code for the plane.

#include "clipping/box/part.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"

namespace clipping {
namespace {

struct CyrusBeckBox {
    template <class T>
    static constexpr T dot(const glm::ivec3& normal, const glm::vec<3, T>& v)
    {
        return T(normal.x) * v.x + T(normal.y) * v.y + T(normal.z) * v.z;
    }
    static constexpr glm::ivec3 innerNormal(Edge side)
    {
        glm::ivec3 normal(0);
        normal[axisOf(side)] = side == lowerEdge(axisOf(side)) ? 1 : -1;
        return normal;
    }

    /// Shortens the part at one side. False: nothing is left.
    template <class T, class Watch>
    static constexpr bool cut(Part<T>& part, Edge side, const BasicSegment<T, 3>& s,
                              const glm::vec<3, T>& d, const BasicWindow<T, 3>& w, Watch& watch)
    {
        const auto normal = innerNormal(side);
        const auto& corner = side == lowerEdge(axisOf(side)) ? w.min : w.max;
        const T speed = dot(normal, d);
        const T depth =
            dot(normal, glm::vec<3, T>{s.a.x - corner.x, s.a.y - corner.y, s.a.z - corner.z});
        if (speed == T(0)) {
            if (depth < T(0))
                return watch("reject", 6, s, side, Named{"D", speed}, Named{"N", depth}), false;
            return true;
        }
        const T t = -depth / speed;
        if (speed > T(0)) {
            if (t > part.start)
                part.start = t, part.startSide = side;
            watch("entry", 11, s, side, Named{"D", speed}, Named{"N", depth}, Named{"t", t});
        } else {
            if (t < part.stop)
                part.stop = t, part.stopSide = side;
            watch("exit", 13, s, side, Named{"D", speed}, Named{"N", depth}, Named{"t", t});
        }
        return true;
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        const glm::vec<3, T> d{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
        Part<T> part{T(0), T(1)};
        for (const Edge side :
             {Edge::Bottom, Edge::Right, Edge::Top, Edge::Left, Edge::Near, Edge::Far})
            if (!cut(part, side, s, d, w, watch))
                return std::nullopt;
        if (part.start > part.stop) {
            watch("reject", 14, s, Edge::None, Named{"tE", part.start}, Named{"tL", part.stop});
            return std::nullopt;
        }
        const BasicSegment<T, 3> visible = endsOf(part, s, d, w);
        if (part.stopSide != Edge::None)
            watch("cut b", 16, BasicSegment<T, 3>{s.a, visible.b}, part.stopSide,
                  Named{"tL", part.stop});
        if (part.startSide != Edge::None)
            watch("cut a", 18, visible, part.startSide, Named{"tE", part.start});
        watch("accept", 19, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> cyrusBeckBox = uses<CyrusBeckBox, Form::Corrected, double, 3>;

} // namespace clipping
