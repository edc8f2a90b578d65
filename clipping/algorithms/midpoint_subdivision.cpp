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
// different reasons, the window lies between them: a contact, which halving alone would lose. A new
// end takes the coordinate of the edge that the next point is beyond, and is held inside the
// window.
//
// How far off: two points of the last step are 2^-53*D apart, 2 units of README.md, which stands
// where it has the two differences that one multiplies and divides; so its k = 24 holds here too.

#include "clipping/box/uses.h"
#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/outcode.h"

#include <limits>

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

    template <class T>
    struct DigitsOf : std::numeric_limits<T> {
    };
    template <class T>
    struct DigitsOf<Counted<T>> : std::numeric_limits<T> {
    };

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

    /// The points of a segment, corrected: the fraction of it that lies before them.
    template <class T>
    class Fractions {
    public:
        using Place = T;
        static constexpr int most = DigitsOf<T>::digits;

        constexpr Fractions(const BasicSegment<T>& s, const BasicWindow<T>& w)
            : segment_(s),
              window_(w), d_{s.b.x - s.a.x, s.b.y - s.a.y}, gaps_{
                                                                {w.min.x - s.a.x, w.min.y - s.a.y},
                                                                {w.max.x - s.a.x, w.max.y - s.a.y}}
        {
        }
        constexpr Place first() const { return T(0); }
        constexpr Place last() const { return T(1); }
        constexpr unsigned code(const T& t) const
        {
            return outcodeOf(glm::vec<2, T>{t * d_.x, t * d_.y}, gaps_);
        }
        static constexpr Place middle(const T& t, const T& u) { return (t + u) * T(0.5); }

        /// The point at t, which lies on the edges that `code` names.
        constexpr glm::vec<2, T> at(const T& t, unsigned code) const
        {
            glm::vec<2, T> p = segment_.b;
            if (t < T(1))
                p = {segment_.a.x + t * d_.x, segment_.a.y + t * d_.y};
            return {code & outcode::left    ? window_.min.x
                    : code & outcode::right ? window_.max.x
                                            : clamped(p.x, window_.min.x, window_.max.x),
                    code & outcode::bottom ? window_.min.y
                    : code & outcode::top  ? window_.max.y
                                           : clamped(p.y, window_.min.y, window_.max.y)};
        }
        constexpr const BasicSegment<T>& between(const T&, const T&) const { return segment_; }

    private:
        const BasicSegment<T>& segment_;
        const BasicWindow<T>& window_;
        glm::vec<2, T> d_;
        BasicWindow<T> gaps_; // from a to each edge
    };

    /// Two points, the visible part's end between them, and their outcodes.
    template <class Place>
    struct Bracket {
        Place near, far;
        unsigned nearCode, farCode;
    };

    /// Halves a bracket as often as it can be; nothing if nothing is visible.
    template <Form form, class Places, class Watch>
    static constexpr std::optional<Bracket<typename Places::Place>>
    halved(const Places& places, Bracket<typename Places::Place> bracket, Watch& watch)
    {
        auto& [near, far, nearCode, farCode] = bracket;
        for (int halvings = 0;; ++halvings) {
            if ((nearCode & farCode) != 0) {
                watch("reject", 7, places.between(near, far), Edge::None);
                return std::nullopt;
            }
            if (halvings == Places::most) {
                if (form == Form::Corrected)
                    return bracket;
                watch("give up", 11, places.between(near, far), Edge::None);
                watch.didNotEnd();
                return std::nullopt;
            }
            const auto middle = places.middle(near, far);
            if constexpr (form == Form::Published)
                if (places.same(middle, near) || places.same(middle, far))
                    return bracket;
            const unsigned code = places.code(middle);
            const bool drop = (code & farCode) != 0;
            (drop ? far : near) = middle;
            (drop ? farCode : nearCode) = code;
            watch("halve", 10, places.between(near, far), Edge::None, Named{"near", nearCode},
                  Named{"far", farCode});
        }
    }

    static constexpr Edge edgeOf(unsigned code)
    {
        return code & outcode::left     ? Edge::Left
               : code & outcode::right  ? Edge::Right
               : code & outcode::bottom ? Edge::Bottom
                                        : Edge::Top;
    }

    template <Form form, class T, class Watch>
    static constexpr std::optional<BasicSegment<T>> clip(const BasicSegment<T>& s,
                                                         const BasicWindow<T>& w, Watch&& watch)
    {
        const unsigned codeA = outcodeOf(s.a, w), codeB = outcodeOf(s.b, w);
        watch("outcodes", 1, s, Edge::None, Named{"a", codeA}, Named{"b", codeB});
        if ((codeA & codeB) != 0) {
            watch("reject", 2, s, Edge::None);
            return std::nullopt;
        }
        BasicSegment<T> visible = s;
        if ((codeA | codeB) != 0) {
            using Places = std::conditional_t<form == Form::Published, Points<T>, Fractions<T>>;
            const Places places(s, w);
            for (const bool last : {true, false}) {
                if ((last ? codeB : codeA) == 0)
                    continue;
                const auto found = halved<form>(
                    places,
                    last ? Bracket<typename Places::Place>{places.first(), places.last(), codeA,
                                                           codeB}
                         : Bracket<typename Places::Place>{places.last(), places.first(), codeB,
                                                           codeA},
                    watch);
                if (!found)
                    return std::nullopt;
                const auto& [near, far, nearCode, farCode] = *found;
                if (form == Form::Published && nearCode != 0) {
                    watch("reject", 9, s, Edge::None);
                    return std::nullopt;
                }
                const glm::vec<2, T> end = places.at(near, nearCode | farCode);
                (last ? visible.b : visible.a) = end;
                watch("cut", last ? 3 : 4, visible, edgeOf(farCode));
                if (nearCode != 0) { // a contact
                    visible = {end, end};
                    break;
                }
            }
        }
        watch("accept", 5, visible, Edge::None);
        return visible;
    }
};

template Algorithm describe<MidpointSubdivision>();

} // namespace clipping
