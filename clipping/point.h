// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <concepts>

namespace CLEARCUT_API clipping {

/// Types with the coordinates of a point: x and y as members or as functions, or [0] and [1].
/// Further coordinates are ignored.
template <class P>
concept PointLike = requires(const P& p)
{
    p.x + p.y;
}
|| requires(const P& p) { p.x() + p.y(); }
|| requires(const P& p) { p[0] + p[1]; };

/// A coordinate of any point, 0 for x and 1 for y.
template <int axis, PointLike P>
constexpr auto coordinateOf(const P& p) noexcept
{
    if constexpr (requires { p.x + p.y; })
        return axis == 0 ? p.x : p.y;
    else if constexpr (requires { p.x() + p.y(); })
        return axis == 0 ? p.x() : p.y();
    else
        return p[axis];
}

/// The number type in which a point of type P is clipped: float for floats, else double.
template <PointLike P>
using NumberOf =
    std::conditional_t<std::same_as<decltype(coordinateOf<0>(std::declval<P>())), float>, float,
                       double>;

/// Any point as a point of the library. Whole numbers beyond 2^53 are rounded.
template <PointLike P>
constexpr glm::vec<2, NumberOf<P>> pointOf(const P& p) noexcept
{
    using T = NumberOf<P>;
    return {static_cast<T>(coordinateOf<0>(p)), static_cast<T>(coordinateOf<1>(p))};
}

/// The segment between any two points of one type.
template <PointLike P>
constexpr BasicSegment<NumberOf<P>> segmentOf(const P& a, const P& b) noexcept
{
    return {pointOf(a), pointOf(b)};
}

/// The window between any two opposite corners of one type.
template <PointLike P>
constexpr BasicWindow<NumberOf<P>> windowOf(const P& p, const P& q) noexcept
{
    const auto a = pointOf(p), b = pointOf(q);
    using Point = glm::vec<2, NumberOf<P>>;
    return {Point(a.x < b.x ? a.x : b.x, a.y < b.y ? a.y : b.y),
            Point(a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y)};
}

} // namespace clipping
