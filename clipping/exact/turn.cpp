// SPDX-License-Identifier: MIT
#include "clipping/exact/turn.h"

#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

#include <optional>

namespace clipping {
namespace {

/// The sign of ux vy - uy vx for exact differences, as numbers on a common grid have; nothing where
/// a product may overflow or underflow. Both products are known exactly as pairs. Rounding is
/// monotone, so where their high parts differ, these decide.
std::optional<int> turnInPairs(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                               const glm::dvec2& d)
{
    const auto ux = twoDifference(b.x, a.x), uy = twoDifference(b.y, a.y);
    const auto vx = twoDifference(d.x, c.x), vy = twoDifference(d.y, c.y);
    if (ux.low != 0 || uy.low != 0 || vx.low != 0 || vy.low != 0)
        return std::nullopt;
    for (const double x : {ux.high, uy.high, vx.high, vy.high})
        if (!(x == 0 || (magnitude(x) > smallestMeeting && magnitude(x) < largestMeeting)))
            return std::nullopt;
    const auto p = twoProduct(ux.high, vy.high), q = twoProduct(uy.high, vx.high);
    const double more = p.high != q.high ? p.high : p.low, less = p.high != q.high ? q.high : q.low;
    return (more > less) - (more < less);
}

} // namespace

int turnInIntegers(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d)
{
    const bool areLevel = (a.x == b.x || c.y == d.y) && (a.y == b.y || c.x == d.x);
    if (areLevel || (a == c && b == d)) // as for an end of a line
        return 0;
    if (const auto sign = turnInPairs(a, b, c, d))
        return *sign;
    const int unit = commonExponent({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
    const auto difference = [unit](double to, double from) {
        return ExactInteger(to, unit) - ExactInteger(from, unit);
    };
    return (difference(b.x, a.x) * difference(d.y, c.y)
            - difference(b.y, a.y) * difference(d.x, c.x))
        .sign();
}

} // namespace clipping
