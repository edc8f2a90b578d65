// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"
#include "clipping/exact/bounds.h"
#include "clipping/exact/line.h"
#include "clipping/wide.h"

// Orientation tests: the side of a line on which a point lies, exact for all finite numbers.
// Computed in floating point where bounds.h proves this sufficient, in integers elsewhere.

namespace clipping {

/// The sign of (b - a) x (d - c), computed in integers alone.
int turnInIntegers(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d);

/// A cross product. The sign is exact; the value is the computed one, or 0 if that has the wrong
/// sign.
template <class T>
struct Cross {
    T value;
    int sign;
};

template <class T>
glm::dvec2 plain(const glm::vec<2, T>& p)
{
    return {plain(p.x), plain(p.y)};
}

/// (b - a) x (d - c), where `ab` is b - a as computed. Its terms are the p and q of `orderBound`.
template <class T>
Cross<T> cross(const glm::vec<2, T>& ab, const glm::vec<2, T>& a, const glm::vec<2, T>& b,
               const glm::vec<2, T>& c, const glm::vec<2, T>& d)
{
    const T p = ab.x * (d.y - c.y), q = ab.y * (d.x - c.x);
    const T value = p - q;
    if (magnitude(value) > T(orderBound) * (magnitude(p) + magnitude(q)) + T(tiny))
        return {value, value > T(0) ? 1 : -1};
    const int sign = turnInIntegers(plain(a), plain(b), plain(c), plain(d));
    const bool agrees = (sign > 0 && value > T(0)) || (sign < 0 && value < T(0));
    return {agrees ? value : T(0), sign};
}

/// The distance of p to the left of the line from `from` to `to`, times the distance of these
/// points.
template <class T>
Cross<T> leftOf(const glm::vec<2, T>& from, const glm::vec<2, T>& to, const glm::vec<2, T>& p)
{
    return cross({to.x - from.x, to.y - from.y}, from, to, from, p);
}

/// The fraction, 0 to 1, of the way from one point to another at which it crosses a line. The
/// arguments are the points' cross products with the line; the points must not be strictly on the
/// same side.
template <class T>
T shareBefore(const Cross<T>& here, const Cross<T>& there)
{
    const T all = here.value - there.value;
    // Two products of 0 have underflowed. Their signs still tell whether a point is on the line; if
    // neither is, the result is 0.
    if (all == T(0))
        return T(here.sign != 0 && there.sign == 0 ? 1 : 0);
    return here.value / all;
}

} // namespace clipping
