// SPDX-License-Identifier: MIT
#include "clipping/exact/turn.h"

#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

int turnInIntegers(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c,
                   const glm::dvec2& d)
{
    if ((a.x == b.x || c.y == d.y) && (a.y == b.y || c.x == d.x))
        return 0;
    const int unit = commonExponent({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
    const auto difference = [unit](double to, double from) {
        return ExactInteger(to, unit) - ExactInteger(from, unit);
    };
    return (difference(b.x, a.x) * difference(d.y, c.y)
            - difference(b.y, a.y) * difference(d.x, c.x))
        .sign();
}

} // namespace clipping
