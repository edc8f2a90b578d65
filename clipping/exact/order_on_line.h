// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/turn.h"

#include <compare>
#include <limits>

// The order in which a segment crosses other segments ("edges"), exact for all finite numbers:
// decided in floating point where a proved bound allows it, in integers elsewhere.

namespace clipping {

/// A cross product and a bound of its error. The sign is exact.
struct BoundedCross {
    double value, error;
    int sign;
};

/// The distance of p to the left of the line from `from` to `to`, times the distance of these
/// points. bounds.h proves the error at `orderBound`.
inline BoundedCross boundedLeftOf(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& p)
{
    const double left = (to.x - from.x) * (p.y - from.y), right = (to.y - from.y) * (p.x - from.x);
    const double value = left - right;
    const double error = orderBound * (magnitude(left) + magnitude(right)) + tiny;
    const int sign = value > error ? 1 : value < -error ? -1 : turnInIntegers(from, to, from, p);
    return {value, error, sign};
}

/// The share of the way from a to b at which a segment crosses an edge. The exact share is within
/// `error` of `value`; an error that is infinite or NaN leaves it open.
struct Share {
    double value, error;
};

/// The share, where `a` and `b` are the ends' cross products with the edge, of opposite signs.
///
/// With A and B the magnitudes, S = A + B and E the sum of both errors, A / S differs from the
/// exact quotient by at most 2 E / (S - E), which is below 2.7 E / S if S > 4 E; rounding the sum
/// and the quotient adds 2 e. The bound is 3 E / S + 4 e, so that comparing `value` plus or minus
/// `error` may round as well.
inline Share shareAt(const BoundedCross& a, const BoundedCross& b)
{
    const double before = magnitude(a.value), sum = before + magnitude(b.value);
    const double error = a.error + b.error;
    if (sum > 4 * error && sum <= std::numeric_limits<double>::max())
        return {before / sum, 3 * error / sum + 0x1p-51};
    return {0, std::numeric_limits<double>::infinity()};
}

/// The order of two crossings in integers alone. The segment must not be parallel to either edge.
std::strong_ordering orderOnLineInIntegers(const Segment& s, const Segment& edge,
                                           const Segment& other);

/// A segment's crossing with an edge. The ends of each must be strictly on both sides of the other.
struct CrossingOnLine {
    Segment edge;
    Share share;
};

/// Whether a segment crosses one edge before, together with or after another.
inline std::strong_ordering orderOnLine(const Segment& s, const CrossingOnLine& p,
                                        const CrossingOnLine& q)
{
    if (p.share.value + p.share.error < q.share.value - q.share.error)
        return std::strong_ordering::less;
    if (q.share.value + q.share.error < p.share.value - p.share.error)
        return std::strong_ordering::greater;
    const auto &e = p.edge, &f = q.edge;
    if (e == f || (e.a == f.b && e.b == f.a)) // shared by two areas, or drawn twice
        return std::strong_ordering::equal;
    return orderOnLineInIntegers(s, e, f);
}

} // namespace clipping
