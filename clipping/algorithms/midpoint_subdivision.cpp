// SPDX-License-Identifier: MIT
//
// Midpoint subdivision (1968).
//
//   R. F. Sproull, I. E. Sutherland: A Clipping Divider. Proceedings of the Fall Joint Computer
//   Conference 33, 1968, 765-775.
//
// Published: halve until a midpoint is one of the two ends that it was to divide.
//
// Corrected: the points are whole multiples of 2^-53 of the segment (2^-24 in float), so that as
// many halvings find each end, whatever the numbers; a point's outcode compares the way from `a` to
// it with the ways to the edges, all of them accurate. Rounding is monotone, hence so are the
// codes: a side that the segment has left stays left. Where the last two points are outside for
// different reasons, the window lies between them: a contact, which halving alone would lose; and
// so it is where both ends are neighbours. A new end takes the coordinate of the edge that the next
// point is beyond, and is held inside the window.
//
// How far off: two points of the last step are 2^-53*D apart, 2 units of README.md, which stands
// where it has the two differences that one multiplies and divides; so its k = 24 holds here too.
// An outcode is wrong within 3e, 6 units: a contact of two ends is off by both steps, both outcodes
// and the 5 of a way that is added, 4 + 12 + 5 = 21.

#include "clipping/box/uses.h"
#include "clipping/describe.h"
#include "clipping/halving.h"
#include "clipping/ieee_numbers.h"
#include "clipping/outcode.h"

namespace clipping {

struct MidpointSubdivision {
    static constexpr About about{
        .key = "midpoint-subdivision",
        .abbreviation = "MS",
        .name = "Midpoint subdivision",
        .year = 1968,
        .idea = "Halve the segment, drop the half that cannot hold the end that is looked for, and "
                "halve the other, until there is nothing left to halve.",
        .ulps = 24,
    };
    static constexpr auto box = &midpointSubdivisionBox;
    /// Where the published form is given up; from 2^1024 to 2^-1074 it takes 2098.
    static constexpr int mostHalvings = 2200;

    /// The points of a segment, as published: what halving leaves, rounded.
    template <class T>
    class Points {
    public:
        using Place = glm::vec<2, T>;
        static constexpr int most = mostHalvings;

        constexpr Points(const BasicSegment<T>& s, const BasicWindow<T>& w)
            : segment_(s), window_(w)
        {
        }
        constexpr const Place& first() const { return segment_.a; }
        constexpr const Place& last() const { return segment_.b; }
        constexpr unsigned code(const Place& p) const { return outcodeOf(p, window_); }
        static constexpr Place middle(const Place& p, const Place& q)
        {
            return {(p.x + q.x) * T(0.5), (p.y + q.y) * T(0.5)};
        }
        static constexpr bool same(const Place& p, const Place& q)
        {
            return p.x == q.x && p.y == q.y;
        }
        constexpr const Place& at(const Place& p, unsigned) const { return p; }
        constexpr BasicSegment<T> between(const Place& p, const Place& q) const { return {p, q}; }

    private:
        const BasicSegment<T>& segment_;
        const BasicWindow<T>& window_;
    };

    static constexpr Edge edgeOf(unsigned code)
    {
        return code & outcode::left     ? Edge::Left
               : code & outcode::right  ? Edge::Right
               : code & outcode::bottom ? Edge::Bottom
                                        : Edge::Top;
    }

    template <Form form, class T, class Watch>
    // NOLINTNEXTLINE(readability-function-size): line by line as the source has it
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        if ((codeA & codeB) != 0) {
            watch("reject", 2, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
            return std::nullopt;
        }
        watch("no", 2, s, Edge::None, Named{"code1", codeA}, Named{"code2", codeB});
        BasicSegment<T> visible = s;
        if ((codeA | codeB) != 0) {
            using Places = std::conditional_t<form == Form::Published, Points<T>, Fractions<T, 2>>;
            using Ends = Bracket<typename Places::Place>;
            const Places places(s, w);
            std::optional<Ends> other; // the end that was found before
            for (const bool last : {true, false}) {
                if ((last ? codeB : codeA) == 0) {
                    watch("no", last ? 3 : 5, visible, Edge::None, Named{"code1", codeA},
                          Named{"code2", codeB});
                    continue;
                }
                watch("yes", last ? 3 : 5, visible, Edge::None, Named{"code1", codeA},
                      Named{"code2", codeB});
                const auto found =
                    halved<form>(places,
                                 last ? Ends{places.first(), places.last(), codeA, codeB}
                                      : Ends{places.last(), places.first(), codeB, codeA},
                                 watch);
                if (!found)
                    return std::nullopt;
                const auto& [near, far, nearCode, farCode] = *found;
                if (form == Form::Published && nearCode != 0) {
                    watch("reject", 11, s, Edge::None);
                    return std::nullopt;
                }
                bool contact = nearCode != 0;
                unsigned codes = found->codes();
                if constexpr (form == Form::Corrected)
                    if (other && Places::areNeighbours(near, other->near)) {
                        contact = true;
                        codes |= other->codes();
                    }
                other = found;
                const glm::vec<2, T> end = places.at(near, codes);
                (last ? visible.b : visible.a) = end;
                watch("cut", last ? 4 : 6, visible, edgeOf(farCode));
                if (contact) {
                    visible = {end, end};
                    break;
                }
            }
        }
        watch("accept", 7, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<MidpointSubdivision>();

} // namespace clipping
