// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/line.h"
#include "clipping/exact/turn.h"

namespace clipping {

/// Conversion of coordinates of type T to the double numbers used for computing, and back.
template <class T>
struct Computing {
    using Number = double;
    using Target = T;
    static constexpr double from(T x) { return x; }
    static constexpr T to(double x) { return static_cast<T>(x); }
};
template <class T>
struct Computing<Counted<T>> {
    using Number = Counted<double>;
    using Target = T;
    static constexpr Number from(Counted<T> x) { return Number(x.value()); }
    static constexpr Counted<T> to(Number x) { return Counted<T>(static_cast<T>(x.value())); }
};

/// The line through a segment's ends, for data of type T: exact for all finite numbers.
template <class T>
struct LineThrough {
    using Numbers = Computing<T>;
    using Number = typename Numbers::Number;
    Number ax, ay, bx, by;

    explicit LineThrough(const BasicSegment<T>& s)
        : ax(Numbers::from(s.a.x)), ay(Numbers::from(s.a.y)), bx(Numbers::from(s.b.x)),
          by(Numbers::from(s.b.y))
    {
    }
    /// Whether the line passes x before, together with or after y.
    std::strong_ordering order(T x, T y) const
    {
        return clipping::order(ax, ay, bx, by, Numbers::from(x), Numbers::from(y));
    }
    /// The side of the line on which (x, y) lies: 1 left, 0 on the line, -1 right. Every point is
    /// on the line of a segment that is a point.
    int side(T x, T y) const
    {
        return leftOf<Number>({ax, ay}, {bx, by}, {Numbers::from(x), Numbers::from(y)}).sign;
    }
    /// The line's y at x, rounded once.
    T yAt(T x) const
    {
        return Numbers::to(crossing<typename Numbers::Target>(ax, ay, bx, by, Numbers::from(x)));
    }
    /// The line's x at y, rounded once.
    T xAt(T y) const
    {
        return Numbers::to(crossing<typename Numbers::Target>(ay, ax, by, bx, Numbers::from(y)));
    }
};

} // namespace clipping
