// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"
#include "clipping/geometry.h"

#include <cmath>

// Where the algorithms do their arithmetic. Between ordinary numbers no difference, product or
// quotient that they form overflows, nor loses digits that matter to underflow. Other finite
// numbers are brought there and back by powers of two, each axis by its own: that is exact, but
// for what is below one part in 2^1000 of the segment's extent.

namespace clipping {

/// Numbers up to 2^250 are ordinary, and so are differences from 2^-250.
inline constexpr double ordinaryMost = 0x1p250, ordinaryLeast = 0x1p-250;

/// Finite, and min <= max: what a corrected form is given.
template <class T>
constexpr bool legal(const BasicWindow<T>& w)
{
    const T zero =
        (w.min.x - w.min.x) + (w.min.y - w.min.y) + (w.max.x - w.max.x) + (w.max.y - w.max.y);
    return zero == T(0) && w.min.x <= w.max.x && w.min.y <= w.max.y;
}
template <class T>
constexpr bool legal(const BasicSegment<T>& s)
{
    return (s.a.x - s.a.x) + (s.a.y - s.a.y) + (s.b.x - s.b.x) + (s.b.y - s.b.y) == T(0);
}

inline bool ordinary(const Window& w)
{
    return (std::abs(w.min.x) <= ordinaryMost) & (std::abs(w.min.y) <= ordinaryMost)
           & (std::abs(w.max.x) <= ordinaryMost) & (std::abs(w.max.y) <= ordinaryMost);
}
inline bool ordinary(const Segment& s)
{
    const double dx = std::abs(s.b.x - s.a.x), dy = std::abs(s.b.y - s.a.y);
    return (std::abs(s.a.x) <= ordinaryMost) & (std::abs(s.a.y) <= ordinaryMost)
           & (std::abs(s.b.x) <= ordinaryMost) & (std::abs(s.b.y) <= ordinaryMost)
           & ((dx >= ordinaryLeast) | (dx == 0)) & ((dy >= ordinaryLeast) | (dy == 0));
}

/// One axis of a frame: it divides by 2^exponent, so that the segment extends by 1 to 2.
class FrameAxis {
public:
    FrameAxis(double a, double b) : exponent_(exponentOf(a, b)) {}

    double into(double x) const
    {
        // What is further out than this is beyond every point of the segment anyway.
        return clamped(std::ldexp(x, -exponent_), -0x1p100, 0x1p100);
    }
    double outOf(double x) const { return std::ldexp(x, exponent_); }

    /// Brings a coordinate of a new end back; `whole` was the old one's, [low, high] is the window.
    double back(double x, double whole, double low, double high) const
    {
        const double restored = x == into(low)     ? low
                                : x == into(high)  ? high
                                : x == into(whole) ? whole
                                                   : outOf(x);
        return clamped(restored, low, high);
    }

private:
    static int exponentOf(double a, double b)
    {
        if (a == b)
            return a == 0 ? 0 : std::ilogb(a);
        const double extent = b - a;
        return std::isfinite(extent) ? std::ilogb(extent) : 1024;
    }
    int exponent_;
};

/// A frame in which a segment, which may have any finite coordinates, is ordinary.
struct Frame {
    FrameAxis x, y;
    explicit Frame(const Segment& s) : x(s.a.x, s.b.x), y(s.a.y, s.b.y) {}

    glm::dvec2 into(const glm::dvec2& p) const { return {x.into(p.x), y.into(p.y)}; }
    Segment into(const Segment& s) const { return {into(s.a), into(s.b)}; }
    Window into(const Window& w) const { return {into(w.min), into(w.max)}; }

    Segment outOf(const Segment& s) const
    {
        return {{x.outOf(s.a.x), y.outOf(s.a.y)}, {x.outOf(s.b.x), y.outOf(s.b.y)}};
    }
    Segment back(const Segment& piece, const Segment& whole, const Window& w) const
    {
        return {back(piece.a, whole.a, w), back(piece.b, whole.b, w)};
    }

private:
    glm::dvec2 back(const glm::dvec2& p, const glm::dvec2& whole, const Window& w) const
    {
        if (p == into(whole))
            return clamped(whole, w);
        return {x.back(p.x, whole.x, w.min.x, w.max.x), y.back(p.y, whole.y, w.min.y, w.max.y)};
    }
};

} // namespace clipping
