// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/meeting.h"
#include "clipping/polygon/crossed.h"

namespace clipping {

/// New ends that are exact points, rounded once: what a method for convex polygons needs to promise
/// the same bits as `exact`.
struct ExactEnds {
    /// Where s crosses an edge whose ends have these signs.
    template <class T>
    static glm::vec<2, T> pointOn(const BasicSegment<T>& edge, int signOfA, int signOfB,
                                  const BasicSegment<T>& s)
    {
        return signOfA == 0 ? edge.a : signOfB == 0 ? edge.b : meeting(s, edge);
    }

    /// A new end, and the number of the edge on which it lies.
    template <class T>
    struct End {
        glm::vec<2, T> at;
        std::uint32_t number;
    };
    /// Where the line crosses edge i. A corner has the number of the edge that begins there.
    template <class T>
    static End<T> endOn(std::size_t i, const OrientedLine<T>& line, const PolygonIn<T>& polygon)
    {
        const std::size_t next = polygon.after(i);
        const BasicSegment<T> edge{polygon.corner(i), polygon.corner(next)};
        const int sign = line.leftOf(edge.a).sign, signOfNext = line.leftOf(edge.b).sign;
        return {pointOn(edge, sign, signOfNext, line.s),
                polygon.number(sign != 0 && signOfNext == 0 ? next : i)};
    }
};

} // namespace clipping
