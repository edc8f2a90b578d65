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
/// (Segments are asked for the square root of a sum of two squares, so for slightly less.)
inline constexpr double ordinaryMost = 0x1p250, ordinaryLeast = 0x1p-250;

/// Finite, and min <= max: what a corrected form is given.
template <class T, glm::length_t N>
constexpr bool legal(const BasicWindow<T, N>& w)
{
    T zero(0);
    bool ordered = true;
    for (glm::length_t k = 0; k < N; ++k) {
        zero += (w.min[k] - w.min[k]) + (w.max[k] - w.max[k]);
        ordered = ordered && w.min[k] <= w.max[k];
    }
    return zero == T(0) && ordered;
}
template <class T, glm::length_t N>
constexpr bool legal(const BasicSegment<T, N>& s)
{
    T zero(0);
    for (glm::length_t k = 0; k < N; ++k)
        zero += (s.a[k] - s.a[k]) + (s.b[k] - s.b[k]);
    return zero == T(0);
}

template <glm::length_t N>
bool ordinary(const BasicWindow<double, N>& w)
{
    bool all = true;
    for (glm::length_t k = 0; k < N; ++k)
        all = all & (std::abs(w.min[k]) <= ordinaryMost) & (std::abs(w.max[k]) <= ordinaryMost);
    return all;
}
template <glm::length_t N>
bool ordinary(const BasicSegment<double, N>& s)
{
    bool all = true;
    for (glm::length_t k = 0; k < N; ++k) {
        const double extent = std::abs(s.b[k] - s.a[k]);
        all = all & (std::abs(s.a[k]) <= ordinaryMost) & (std::abs(s.b[k]) <= ordinaryMost)
              & ((extent >= ordinaryLeast) | (extent == 0));
    }
    return all;
}

/// In the plane both axes are asked at once, by squares: every segment of every row is asked.
inline bool ordinary(const Segment& s)
{
    using Two [[gnu::vector_size(16)]] = double;
    constexpr double most = ordinaryMost * ordinaryMost, least = ordinaryLeast * ordinaryLeast;
    const Two a{s.a.x, s.a.y}, b{s.b.x, s.b.y}, extent = b - a;
    const auto fine = (a * a + b * b <= most) & ((extent * extent >= least) | (extent == 0.0));
    return (fine[0] & fine[1]) != 0;
}

/// One axis of a frame: it divides by 2^exponent, so that the segment extends by 1 to 2.
class FrameAxis {
public:
    FrameAxis() = default;
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
    int exponent_ = 0;
};

/// A frame in which a segment, which may have any finite coordinates, is ordinary.
template <glm::length_t N>
class Frame {
public:
    using Point = glm::vec<N, double>;
    using Segment = BasicSegment<double, N>;
    using Window = BasicWindow<double, N>;

    explicit Frame(const Segment& s)
    {
        for (glm::length_t k = 0; k < N; ++k)
            axes_[k] = FrameAxis(s.a[k], s.b[k]);
    }
    Point into(Point p) const
    {
        for (glm::length_t k = 0; k < N; ++k)
            p[k] = axes_[k].into(p[k]);
        return p;
    }
    Segment into(const Segment& s) const { return {into(s.a), into(s.b)}; }
    Window into(const Window& w) const { return {into(w.min), into(w.max)}; }
    Segment outOf(const Segment& s) const { return {outOf(s.a), outOf(s.b)}; }
    Segment back(const Segment& piece, const Segment& whole, const Window& w) const
    {
        return {back(piece.a, whole.a, w), back(piece.b, whole.b, w)};
    }

private:
    Point outOf(Point p) const
    {
        for (glm::length_t k = 0; k < N; ++k)
            p[k] = axes_[k].outOf(p[k]);
        return p;
    }
    Point back(Point p, const Point& whole, const Window& w) const
    {
        if (p == into(whole))
            return clamped(whole, w);
        for (glm::length_t k = 0; k < N; ++k)
            p[k] = axes_[k].back(p[k], whole[k], w.min[k], w.max[k]);
        return p;
    }
    FrameAxis axes_[N];
};

} // namespace clipping
