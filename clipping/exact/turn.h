// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"
#include "clipping/exact/bounds.h"
#include "clipping/exact/line.h"
#include "clipping/wide.h"

// On which side of a line a point lies, without error for all finite numbers: in floating point
// where bounds.h proves that enough, in whole numbers elsewhere.

namespace clipping {

/// The sign of (b - a) x (d - c), from whole numbers alone.
int turnInIntegers(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d);

/// A cross product as far as it is known: its sign is exact; its value is computed, and 0 where the
/// computed one has not the right sign.
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

/// How far p lies to the left of the line from `from` to `to`, times their distance.
template <class T>
Cross<T> leftOf(const glm::vec<2, T>& from, const glm::vec<2, T>& to, const glm::vec<2, T>& p)
{
    return cross({to.x - from.x, to.y - from.y}, from, to, from, p);
}

/// How much of the way from a point to another lies before the line about which they have these
/// products, one of them on either side or on it: 0 to 1.
template <class T>
T shareBefore(const Cross<T>& here, const Cross<T>& there)
{
    const T all = here.value - there.value;
    // Two products of 0 are too small to compute. Who is on the line is known by the sign all the
    // same; where neither is, the answer is 0.
    if (all == T(0))
        return T(here.sign != 0 && there.sign == 0 ? 1 : 0);
    return here.value / all;
}

} // namespace clipping
