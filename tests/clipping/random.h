// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <type_traits>

/// Numbers of a fixed seed; the distributions are our own, so that they are the same everywhere.
class Random {
public:
    explicit Random(unsigned seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double between(double low, double high) { return low + unit() * (high - low); }
    int whole(int low, int high) { return low + int(engine_() % std::uint64_t(high - low + 1)); }
    template <class T, std::size_t n>
    T of(const std::array<T, n>& all)
    {
        return all[engine_() % n];
    }

private:
    std::mt19937_64 engine_;
};

template <class T>
using Limits = std::numeric_limits<T>;

/// The T nearest to x, and so many numbers further up, or down, from there.
template <class T = double>
T nudged(double x, int ulps)
{
    T nudged = T(x);
    for (int i = 0; i < std::abs(ulps); ++i)
        nudged = std::nextafter(nudged, T(ulps < 0 ? -INFINITY : INFINITY));
    return nudged;
}

/// The powers of two that a T can be.
template <class T>
constexpr int leastExponent = Limits<T>::min_exponent - Limits<T>::digits;
template <class T>
constexpr int mostExponent = Limits<T>::max_exponent - 1;

/// A number of any size: ordinary, huge, tiny, denormal, or far from zero.
template <class T = double>
T anyNumber(Random& r)
{
    constexpr bool single = std::is_same_v<T, float>;
    constexpr T denormal = Limits<T>::denorm_min(), epsilon = Limits<T>::epsilon();
    constexpr T small = T(single ? 1e-36 : 1e-300), large = T(single ? 1e37 : 1e300);
    constexpr T root = T(single ? 1e18 : 1e154), smallRoot = T(single ? 1e-19 : 1e-160);
    constexpr std::array special{T(0),
                                 -T(0),
                                 T(1),
                                 T(-1),
                                 denormal,
                                 -denormal,
                                 3 * denormal,
                                 Limits<T>::min(),
                                 small,
                                 -small,
                                 root,
                                 smallRoot,
                                 T(single ? 1e7 : 1e15),
                                 -root,
                                 large,
                                 -large,
                                 epsilon / 2,
                                 1 + epsilon};
    switch (r.whole(0, 5)) {
    case 0:
        return r.of(special);
    case 1:
        return T(r.between(-1, 1) * std::ldexp(1.0, r.whole(leastExponent<T>, mostExponent<T>)));
    case 2:
        return T(r.between(-1, 1) * Limits<T>::max());
    case 3:
        return T(r.whole(-9, 9) * denormal);
    case 4:
        return nudged<T>(r.of(special), r.whole(-4, 4));
    default:
        return T(r.between(-10, 10));
    }
}
