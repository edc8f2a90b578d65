// SPDX-License-Identifier: MIT
//
// Cohen-Sutherland in three dimensions: outcodes of six bits. As in the plane, a side that has cut
// an end never cuts it again, so that six cuts an end are the most. The lines of the steps are
// those of the pseudo-code for the plane, which has none for near and far.

#include "clipping/box/moving_end.h"
#include "clipping/box/uses.h"
#include "clipping/describe.h"

#include <bit>

namespace clipping {
namespace {

struct CohenSutherlandBox {
    static constexpr int lineOf(Edge side)
    {
        return side < Edge::Near ? 20 - 3 * static_cast<int>(side) : 0; // 8 to 17 for top to left
    }

    /// An end, the sides it is beyond, and those that have cut it.
    template <class T>
    struct End {
        MovingEnd<T> end;
        unsigned code, done = 0;

        constexpr Edge cut()
        {
            const Edge side = static_cast<Edge>(std::bit_width(code)); // the last that code names
            end.moveTo(side);
            done |= 1U << (static_cast<int>(side) - 1);
            code = 0;
            for (glm::length_t k = 0; k < 3; ++k)
                code |= (end.isBelow(k)   ? outcode::left
                         : end.isAbove(k) ? outcode::right
                                          : 0)
                        << 2 * k;
            code &= ~done;
            return side;
        }
    };

    template <class T>
    static constexpr BasicSegment<T, 3> left(const End<T>& a, const End<T>& b)
    {
        return {a.end.at(), b.end.at()};
    }

    template <Form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T, 3>>
    clip(const BasicSegment<T, 3>& s, const BasicWindow<T, 3>& w, Watch&& watch)
    {
        const glm::vec<3, T> d{s.b.x - s.a.x, s.b.y - s.a.y, s.b.z - s.a.z};
        End<T> a{{s.a, d, w}, outcodeOf(s.a, w)}, b{{s.b, d, w}, outcodeOf(s.b, w)};
        watch("outcodes", 1, s, Edge::None, Named{"code1", a.code}, Named{"code2", b.code});
        while ((a.code | b.code) != 0) {
            if ((a.code & b.code) != 0) {
                watch("reject", 4, left(a, b), Edge::None, Named{"code1", a.code},
                      Named{"code2", b.code});
                return std::nullopt;
            }
            const Edge side = (a.code != 0 ? a : b).cut();
            watch("cut", lineOf(side), left(a, b), side, Named{"code1", a.code},
                  Named{"code2", b.code});
        }
        const BasicSegment<T, 3> visible = between(a.end, b.end);
        watch("accept", 3, visible, Edge::None);
        return visible;
    }
};

} // namespace

const Uses<Segment3, Window3> cohenSutherlandBox =
    uses<CohenSutherlandBox, Form::Corrected, double, 3>;

} // namespace clipping
