// SPDX-License-Identifier: MIT
//
// Liang-Barsky in three dimensions: as in the plane, with two more sides. The lines of the steps
// are those of the pseudo-code for the plane.

#include "clipping/box/part.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"

namespace clipping {
namespace {

struct LiangBarskyBox {
    /// Shortens the part at one side; p is how fast the segment leaves that side's half-space, q
    /// how far its a is from leaving it. False: nothing is left.
    template <class T, class Watch>
    static constexpr bool cut(Part<T>& part, T p, T q, Edge side, const BasicSegment<T, 3>& s,
                              Watch& watch)
    {
        if (p < T(0)) {
            const T r = q / p;
            if (r > part.stop)
                return watch("reject", 7, s, side, Named{"p", p}, Named{"q", q}, Named{"r", r}),
                       false;
            if (r > part.start) {
                part.start = r, part.startSide = side;
                watch("start", 9, s, side, Named{"p", p}, Named{"q", q}, Named{"r", r});
            }
        } else if (p > T(0)) {
            const T r = q / p;
            if (r < part.start)
                return watch("reject", 12, s, side, Named{"p", p}, Named{"q", q}, Named{"r", r}),
                       false;
            if (r < part.stop) {
                part.stop = r, part.stopSide = side;
                watch("stop", 14, s, side, Named{"p", p}, Named{"q", q}, Named{"r", r});
            }
        } else if (q < T(0))
            return watch("reject", 15, s, side, Named{"p", p}, Named{"q", q}), false;
        return true;
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        Part<T> part{T(0), T(1)};
        glm::vec<3, T> d;
        for (glm::length_t k = 0; k < 3; ++k) {
            d[k] = s.b[k] - s.a[k];
            if (!cut(part, -d[k], s.a[k] - w.min[k], lowerEdge(k), s, watch)
                || !cut(part, d[k], w.max[k] - s.a[k], upperEdge(k), s, watch))
                return std::nullopt;
        }
        const BasicSegment<T, 3> visible = endsOf(part, s, d, w);
        if (part.stopSide != Edge::None)
            watch("cut b", 17, BasicSegment<T, 3>{s.a, visible.b}, part.stopSide,
                  Named{"u1", part.stop});
        if (part.startSide != Edge::None)
            watch("cut a", 19, visible, part.startSide, Named{"u0", part.start});
        watch("accept", 20, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> liangBarskyBox = uses<LiangBarskyBox, Form::Corrected, double, 3>;

} // namespace clipping
