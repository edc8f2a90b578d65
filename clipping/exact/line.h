// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/counted.h"
#include "clipping/exact/bounds.h"

#include <compare>

// The two functions of the line through two points that clipping needs, exact for all finite
// numbers: computed in floating point where bounds.h proves this sufficient (nearly always), in
// integers elsewhere. They take coordinates, not points, so that the axes can be exchanged. N is
// double, or Counted<double> to count operations; T is the number type of the drawing, double or
// float, whose values are exact in double.

namespace clipping {

/// A number and its rounding error: high + low is the unrounded value.
template <class N>
struct NumberPair {
    N high, low;
};

/// a - b by Knuth's two-sum: exact unless the difference overflows.
template <class N>
constexpr NumberPair<N> twoDifference(N a, N b)
{
    const N difference = a - b;
    const N ofB = difference - a;
    return {difference, (a - (difference - ofB)) - (b + ofB)};
}

/// Dekker's product, exact unless it is near the ends of the range. Not std::fma, which is a slow
/// function call where the hardware lacks it.
template <class N>
constexpr NumberPair<N> twoProduct(N a, N b)
{
    const auto split = [](N x) {
        const N scaled = N(0x8000001p0) * x;
        const N high = scaled - (scaled - x);
        return NumberPair<N>{high, x - high};
    };
    const auto [ah, al] = split(a);
    const auto [bh, bl] = split(b);
    const N product = a * b;
    return {product, ((ah * bh - product) + ah * bl + al * bh) + al * bl};
}

template <class N>
constexpr N magnitude(N x)
{
    return x < N(0) ? -x : x;
}

/// `order` and `crossing` in integers alone.
std::strong_ordering orderInIntegers(double ax, double ay, double bx, double by, double x,
                                     double y);
template <class T>
double crossingInIntegers(double ax, double ay, double bx, double by, double x);

/// Whether the line from (ax, ay) to (bx, by) passes x before, together with or after it passes y:
/// the sign of (x - ax) / (bx - ax) - (y - ay) / (by - ay). Needs ax != bx and ay != by.
template <class N>
// NOLINTNEXTLINE(readability-function-size): two coordinates for each of three points
std::strong_ordering order(N ax, N ay, N bx, N by, N x, N y)
{
    const N p = (x - ax) * (by - ay), q = (y - ay) * (bx - ax);
    const bool along = (bx > ax) == (by > ay); // both denominators have the same sign
    if (magnitude(p - q) > N(orderBound) * (magnitude(p) + magnitude(q)) + N(tiny))
        return (p > q) == along ? std::strong_ordering::greater : std::strong_ordering::less;
    return orderInIntegers(plain(ax), plain(ay), plain(bx), plain(by), plain(x), plain(y));
}

/// The line's y at x, rounded once to the nearest T, ties to even; never -0. Needs ax != bx, and a
/// result within T's range.
template <class T, class N>
N crossing(N ax, N ay, N bx, N by, N x)
{
    const auto m = twoDifference(by, ay), u = twoDifference(x, ax), d = twoDifference(bx, ax);
    const auto p = twoProduct(m.high, u.high);
    const N low = p.low + m.high * u.low + m.low * u.high;
    const N q = p.high / d.high;
    const auto back = twoProduct(q, d.high);
    const N rest = (((p.high - back.high) - back.low) + low) - q * d.low;
    const auto s = twoDifference(ay, -q);
    const N t = s.low + rest / d.high;
    const N error = N(quotientBound) * magnitude(q) + N(sumBound<T>) * magnitude(s.high);
    const auto below = static_cast<T>(plain(s.high + (t - error)));
    const auto above = static_cast<T>(plain(s.high + (t + error)));
    const double product = plain(magnitude(p.high)), quotient = plain(magnitude(q));
    const bool tame = (product >= smallestProduct && product <= largestProduct
                       && quotient >= smallestQuotient && quotient <= largestQuotient)
                      || plain(m.high) == 0;
    if (tame && below == above)
        return N(below + 0.0); // never -0
    return N(crossingInIntegers<T>(plain(ax), plain(ay), plain(bx), plain(by), plain(x)));
}

} // namespace clipping
