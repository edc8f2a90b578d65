// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

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

/// So many numbers further up, or down.
inline double nudged(double x, int ulps)
{
    const double towards = ulps < 0 ? -INFINITY : INFINITY;
    for (int i = 0; i < std::abs(ulps); ++i)
        x = std::nextafter(x, towards);
    return x;
}

/// A number of any size: plain, huge, tiny, denormal, far off zero.
inline double anyNumber(Random& r)
{
    constexpr std::array special{0.0,           -0.0,      1.0,    -1.0,    0x1p-1074, -0x1p-1074,
                                 3 * 0x1p-1074, 0x1p-1022, 1e-300, -1e-300, 1e-160,    1e15,
                                 1e154,         -1e154,    1e300,  -1e300,  0x1p-53,   1 + 0x1p-52};
    switch (r.whole(0, 5)) {
    case 0:
        return r.of(special);
    case 1:
        return r.between(-1, 1) * std::ldexp(1.0, r.whole(-1074, 1023));
    case 2:
        return r.between(-1, 1) * std::numeric_limits<double>::max();
    case 3:
        return r.whole(-9, 9) * 0x1p-1074;
    case 4:
        return nudged(r.of(special), r.whole(-4, 4));
    default:
        return r.between(-10, 10);
    }
}
