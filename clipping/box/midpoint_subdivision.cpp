// SPDX-License-Identifier: MIT
//
// Midpoint subdivision in three dimensions, as the row's corrected form does it in the plane:
// points are whole multiples of 2^-53 of the segment, and their outcodes (of six bits) compare the
// way from a with the ways to the sides. Where the last two points are outside for different
// reasons, or both ends are found within a step of each other, the segment touches the box in a
// point.
//
// How far off: a step is e*D, 2 units; an outcode is wrong within 3e, 6 units; the way from a, and
// adding it, 5. So k is far below that of README.md, "Boxes". The lines of the steps are those of
// the pseudo-code for the plane.

#include "clipping/box/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/outcode.h"

#include <bit>

namespace clipping {
namespace {

struct MidpointSubdivisionBox {
    static constexpr int halvings = 53;

    /// The points of a segment, by the fraction of it that lies before them.
    template <class T>
    struct Fractions {
        const BasicSegment<T, 3>& segment;
        const BasicWindow<T, 3>& window;
        glm::vec<3, T> d;
        BasicWindow<T, 3> gaps; // from a to each side

        constexpr Fractions(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w)
            : segment(s), window(w)
        {
            for (glm::length_t k = 0; k < 3; ++k) {
                d[k] = s.b[k] - s.a[k];
                gaps.min[k] = w.min[k] - s.a[k];
                gaps.max[k] = w.max[k] - s.a[k];
            }
        }
        constexpr unsigned code(const T& t) const
        {
            return outcodeOf(glm::vec<3, T>{t * d.x, t * d.y, t * d.z}, gaps);
        }
        /// The point at t, which lies on the sides that `code` names.
        constexpr glm::vec<3, T> at(const T& t, unsigned code) const
        {
            glm::vec<3, T> p = segment.b;
            for (glm::length_t k = 0; k < 3; ++k) {
                if (t < T(1))
                    p[k] = segment.a[k] + t * d[k];
                const unsigned side = code >> 2 * k;
                p[k] = side & outcode::left    ? window.min[k]
                       : side & outcode::right ? window.max[k]
                                               : clamped(p[k], window.min[k], window.max[k]);
            }
            return p;
        }
    };

    /// Two points, an end of the visible part between them, and their outcodes.
    template <class T>
    struct Bracket {
        T near, far;
        unsigned nearCode, farCode;
        constexpr unsigned codes() const { return nearCode | farCode; }
    };

    /// Halves a bracket until its points are neighbours; nothing if nothing is visible.
    template <class T, class Watch>
    static constexpr std::optional<Bracket<T>> halved(const Fractions<T>& points, Bracket<T> all,
                                                      Watch& watch)
    {
        for (int i = 0; (all.nearCode & all.farCode) == 0; ++i) {
            if (i == halvings)
                return all;
            const T middle = (all.near + all.far) * T(0.5);
            const unsigned code = points.code(middle);
            const bool drop = (code & all.farCode) != 0;
            (drop ? all.far : all.near) = middle;
            (drop ? all.farCode : all.nearCode) = code;
            watch("halve", 10, points.segment, Edge::None, Named{"near", all.nearCode},
                  Named{"far", all.farCode});
        }
        watch("reject", 7, points.segment, Edge::None);
        return std::nullopt;
    }

    static constexpr Edge sideOf(unsigned code)
    {
        return static_cast<Edge>(std::countr_zero(code) + 1);
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"a", codeA}, Named{"b", codeB});
        if ((codeA & codeB) != 0) {
            watch("reject", 2, s, Edge::None);
            return std::nullopt;
        }
        const Fractions<T> points(s, w);
        BasicSegment<T, 3> visible = s;
        std::optional<Bracket<T>> last, first;
        if (codeB != 0) {
            last = halved(points, Bracket<T>{T(0), T(1), codeA, codeB}, watch);
            if (!last)
                return std::nullopt;
            visible.b = points.at(last->near, last->codes());
            watch("cut", 3, visible, sideOf(last->farCode));
        }
        if (codeA != 0) {
            first = halved(points, Bracket<T>{T(1), T(0), codeB, codeA}, watch);
            if (!first)
                return std::nullopt;
            visible.a = points.at(first->near, first->codes());
            watch("cut", 4, visible, sideOf(first->farCode));
        }
        constexpr double step = 0x1p-53;
        if (first && last && last->near - first->near <= T(step)) {
            const auto touch = points.at(last->near, last->codes() | first->codes());
            visible = {touch, touch};
        }
        watch("accept", 5, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> midpointSubdivisionBox =
    uses<MidpointSubdivisionBox, Form::Corrected, double, 3>;

} // namespace clipping
