// SPDX-License-Identifier: MIT
#include "clipping/exact/order_on_line.h"

#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

std::strong_ordering orderOnLineInIntegers(const Segment& s, const Segment& edge,
                                           const Segment& other)
{
    const int unit = commonExponent({s.a.x, s.a.y, s.b.x, s.b.y, edge.a.x, edge.a.y, edge.b.x,
                                     edge.b.y, other.a.x, other.a.y, other.b.x, other.b.y});
    const auto difference = [unit](double to, double from) {
        return ExactInteger(to, unit) - ExactInteger(from, unit);
    };
    // (q - p) x (v - u)
    const auto cross = [&](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& u,
                           const glm::dvec2& v) {
        return difference(q.x, p.x) * difference(v.y, u.y)
               - difference(q.y, p.y) * difference(v.x, u.x);
    };
    // The share of each crossing is over / under.
    const auto over = cross(s.a, edge.a, edge.a, edge.b), under = cross(s.a, s.b, edge.a, edge.b);
    const auto overOther = cross(s.a, other.a, other.a, other.b);
    const auto underOther = cross(s.a, s.b, other.a, other.b);
    return (over * underOther - overOther * under).sign() * under.sign() * underOther.sign() <=> 0;
}

} // namespace clipping
