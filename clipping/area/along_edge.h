// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/beside.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clipping {

/// Whether p comes before q in the direction of a line on which both lie.
inline bool comesBefore(const DirectedLine& line, const glm::dvec2& p, const glm::dvec2& q)
{
    return line.signX() != 0 ? line.signX() * signOf(p.x, q.x) > 0
                             : line.signY() * signOf(p.y, q.y) > 0;
}

/// The share of the way along an edge at which a point lies: 0 and 1 for its ends, and between them
/// for every other point, even if it rounds to an end. It is taken on the longer axis, where the
/// point is between the edge's ends. Three roundings: two differences and a quotient.
inline double shareAlong(const Segment& edge, const glm::dvec2& p)
{
    if (p == edge.a || p == edge.b)
        return p == edge.a ? 0 : 1;
    const auto share = [](double from, double to, double x) {
        const double way = to - from;
        return std::isfinite(way) ? (x - from) / way : (x / 2 - from / 2) / (to / 2 - from / 2);
    };
    const bool isLevel =
        std::abs(edge.b.x / 2 - edge.a.x / 2) >= std::abs(edge.b.y / 2 - edge.a.y / 2);
    const bool onX = isLevel && edge.a.x != edge.b.x;
    const double exact = onX ? share(edge.a.x, edge.b.x, p.x) : share(edge.a.y, edge.b.y, p.y);
    return std::clamp(exact, std::numeric_limits<double>::min(), 1 - 0x1p-53);
}

} // namespace clipping
