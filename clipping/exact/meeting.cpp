// SPDX-License-Identifier: MIT
#include "clipping/exact/meeting.h"

#include "clipping/exact/quotient.h"
#include "clipping/ieee_numbers.h"

namespace clipping {

glm::dvec2 meetingInIntegers(const Segment& s, const Segment& edge)
{
    const auto &a = s.a, &b = s.b, &c = edge.a, &d = edge.b;
    const int unit = commonExponent({a.x, a.y, b.x, b.y, c.x, c.y, d.x, d.y});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const auto difference = [&](double to, double from) { return whole(to) - whole(from); };
    const ExactInteger wayX = difference(b.x, a.x), wayY = difference(b.y, a.y);
    const ExactInteger edgeX = difference(d.x, c.x), edgeY = difference(d.y, c.y);
    const ExactInteger over = difference(c.x, a.x) * edgeY - difference(c.y, a.y) * edgeX;
    const ExactInteger under = wayX * edgeY - wayY * edgeX;
    return {nearest<double>(whole(a.x) * under + wayX * over, under, unit),
            nearest<double>(whole(a.y) * under + wayY * over, under, unit)};
}

} // namespace clipping
