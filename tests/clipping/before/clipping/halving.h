// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"
#include "clipping/describe.h"
#include "clipping/outcode.h"

#include <limits>
#include <optional>

// What midpoint subdivision halves, in the plane and in three dimensions.

namespace clipping {

/// The points of a segment by the fraction of it that lies before them: whole multiples of 2^-53,
/// in float of 2^-24, so that as many halvings find each end.
template <class T, glm::length_t N>
class Fractions {
    template <class U>
    struct DigitsOf : std::numeric_limits<U> {
    };
    template <class U>
    struct DigitsOf<Counted<U>> : std::numeric_limits<U> {
    };

public:
    using Place = T;
    static constexpr int most = DigitsOf<T>::digits;

    constexpr Fractions(const BasicSegment<T, N>& s, const BasicWindow<T, N>& w)
        : segment_(s), window_(w)
    {
        for (glm::length_t k = 0; k < N; ++k) {
            d_[k] = s.b[k] - s.a[k];
            gaps_.min[k] = w.min[k] - s.a[k];
            gaps_.max[k] = w.max[k] - s.a[k];
        }
    }
    constexpr Place first() const { return T(0); }
    constexpr Place last() const { return T(1); }
    constexpr unsigned code(const T& t) const
    {
        glm::vec<N, T> way;
        for (glm::length_t k = 0; k < N; ++k)
            way[k] = t * d_[k];
        return outcodeOf(way, gaps_);
    }
    static constexpr Place middle(const T& t, const T& u) { return (t + u) * T(0.5); }
    /// Whether u is at most the next point after t.
    static constexpr bool areNeighbours(const T& t, const T& u)
    {
        return u - t <= T(1.0 / double(1ULL << most));
    }

    /// The point at t, which lies on the sides that `code` names.
    constexpr glm::vec<N, T> at(const T& t, unsigned code) const
    {
        glm::vec<N, T> p = segment_.b;
        if (t < T(1))
            for (glm::length_t k = 0; k < N; ++k)
                p[k] = segment_.a[k] + t * d_[k];
        for (glm::length_t k = 0; k < N; ++k) {
            const unsigned side = code >> 2 * k;
            p[k] = side & outcode::left    ? window_.min[k]
                   : side & outcode::right ? window_.max[k]
                                           : clamped(p[k], window_.min[k], window_.max[k]);
        }
        return p;
    }
    constexpr const BasicSegment<T, N>& between(const T&, const T&) const { return segment_; }

private:
    const BasicSegment<T, N>& segment_;
    const BasicWindow<T, N>& window_;
    glm::vec<N, T> d_;
    BasicWindow<T, N> gaps_; // from a to each side
};

/// Two points, an end of the visible part between them, and their outcodes.
template <class Place>
struct Bracket {
    Place near, far;
    unsigned nearCode, farCode;
    constexpr unsigned codes() const { return nearCode | farCode; }
};

/// Halves a bracket as often as it can be; nothing if nothing is visible.
template <Form form, class Places, class Watch>
constexpr std::optional<Bracket<typename Places::Place>>
halved(const Places& places, Bracket<typename Places::Place> bracket, Watch& watch)
{
    auto& [near, far, nearCode, farCode] = bracket;
    for (int halvings = 0;; ++halvings) {
        if ((nearCode & farCode) != 0) {
            watch("reject", 9, places.between(near, far), Edge::None, Named{"near", nearCode},
                  Named{"far", farCode});
            return std::nullopt;
        }
        if (halvings == Places::most) {
            if (form == Form::Corrected)
                return bracket;
            watch("give up", 14, places.between(near, far), Edge::None);
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
        if constexpr (form == Form::Corrected)
            watch("halve", drop ? 12 : 13, places.between(near, far), Edge::None,
                  Named{"t", middle}, Named{"M", code}, Named{"near", nearCode},
                  Named{"far", farCode});
        else
            watch("halve", drop ? 12 : 13, places.between(near, far), Edge::None, Named{"M", code},
                  Named{"near", nearCode}, Named{"far", farCode});
    }
}

} // namespace clipping
