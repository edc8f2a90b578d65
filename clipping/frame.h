// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/clamped.h"
#include "clipping/geometry.h"

#include <cmath>
#include <limits>

// The frame in which the algorithms compute, in double or in float. With ordinary numbers no
// difference, product or quotient in an algorithm overflows or loses significant digits to
// underflow. Other finite numbers are scaled into the ordinary range and back by powers of two,
// separately on each axis. This is exact except for digits below one part in 2^1000 (2^100 in
// float) of the segment's extent.

namespace clipping {

/// Coordinates up to this magnitude, and differences down to its reciprocal, are ordinary: a
/// product of two differences, divided by a third, is far from overflow. (For segments the bound
/// applies to the square root of a sum of two squares, so it is slightly stricter.)
template <class T>
inline constexpr T ordinaryMost = T(0x1p250);
template <>
inline constexpr float ordinaryMost<float> = 0x1p40F;
template <class T>
inline constexpr T ordinaryLeast = T(1) / ordinaryMost<T>;

/// All numbers finite, and min <= max; the precondition of a corrected form.
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

template <class T, glm::length_t N>
bool ordinary(const BasicWindow<T, N>& w)
{
    constexpr T most = ordinaryMost<T>;
    bool all = true;
    for (glm::length_t k = 0; k < N; ++k) {
        all &= std::abs(w.min[k]) <= most;
        all &= std::abs(w.max[k]) <= most;
    }
    return all;
}
template <class T, glm::length_t N>
bool ordinary(const BasicSegment<T, N>& s)
{
    constexpr T most = ordinaryMost<T>, least = ordinaryLeast<T>;
    bool all = true;
    for (glm::length_t k = 0; k < N; ++k) {
        const T extent = std::abs(s.b[k] - s.a[k]);
        all &= std::abs(s.a[k]) <= most;
        all &= std::abs(s.b[k]) <= most;
        all &= (extent >= least) | (extent == 0);
    }
    return all;
}

/// In the plane both axes are tested at once, using squares, because this test runs for every
/// segment.
template <class T>
bool ordinary(const BasicSegment<T, 2>& s)
{
    using Two [[gnu::vector_size(2 * sizeof(T))]] = T;
    constexpr T most = ordinaryMost<T> * ordinaryMost<T>;
    constexpr T least = ordinaryLeast<T> * ordinaryLeast<T>;
    const Two a{s.a.x, s.a.y}, b{s.b.x, s.b.y}, extent = b - a;
    const auto fine = (a * a + b * b <= most) & ((extent * extent >= least) | (extent == T(0)));
    return (fine[0] & fine[1]) != 0;
}

/// One axis of a frame. It divides by 2^exponent, so that the segment's extent becomes 1 to 2.
template <class T>
class FrameAxis {
public:
    FrameAxis() = default;
    FrameAxis(T a, T b) : exponent_(exponentOf(a, b)) {}

    T into(T x) const
    {
        // Coordinates beyond this limit are beyond every point of the segment anyway.
        constexpr T beyond = std::is_same_v<T, float> ? T(0x1p39) : T(0x1p100);
        return clamped(std::ldexp(x, -exponent_), -beyond, beyond);
    }
    template <class Number>
    Number outOf(Number x) const
    {
        return std::ldexp(x, exponent_);
    }

    /// Converts a coordinate of a new end back. `whole` is the coordinate of the input's end, [low,
    /// high] the window's range.
    T back(T x, T whole, T low, T high) const
    {
        const T restored = x == into(low)     ? low
                           : x == into(high)  ? high
                           : x == into(whole) ? whole
                                              : outOf(x);
        return clamped(restored, low, high);
    }

private:
    static int exponentOf(T a, T b)
    {
        if (a == b)
            return a == 0 ? 0 : std::ilogb(a);
        const T extent = b - a;
        return std::isfinite(extent) ? std::ilogb(extent) : std::numeric_limits<T>::max_exponent;
    }
    int exponent_ = 0;
};

/// A frame in which a segment with any finite coordinates becomes ordinary.
template <class T, glm::length_t N>
class Frame {
public:
    using Point = glm::vec<N, T>;
    using Segment = BasicSegment<T, N>;
    using Window = BasicWindow<T, N>;

    explicit Frame(const Segment& s)
    {
        for (glm::length_t k = 0; k < N; ++k)
            axes_[k] = FrameAxis<T>(s.a[k], s.b[k]);
    }
    Point into(Point p) const
    {
        for (glm::length_t k = 0; k < N; ++k)
            p[k] = axes_[k].into(p[k]);
        return p;
    }
    Segment into(const Segment& s) const { return {into(s.a), into(s.b)}; }
    Window into(const Window& w) const { return {into(w.min), into(w.max)}; }
    /// The original coordinates for a trace, always in double.
    BasicSegment<double, N> outOf(const BasicSegment<double, N>& s) const
    {
        return {outOf(s.a), outOf(s.b)};
    }
    Segment back(const Segment& piece, const Segment& whole, const Window& w) const
    {
        return {back(piece.a, whole.a, w), back(piece.b, whole.b, w)};
    }

private:
    glm::vec<N, double> outOf(glm::vec<N, double> p) const
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
    FrameAxis<T> axes_[N];
};

} // namespace clipping
