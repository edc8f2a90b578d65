// SPDX-License-Identifier: MIT
#include "clipping/exact/line.h"

#include "clipping/exact/integer.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <initializer_list>
#include <limits>

namespace clipping {
namespace {

/// The largest exponent such that all these numbers are integer multiples of 2^exponent.
int commonExponent(std::initializer_list<double> values)
{
    int lowest = std::numeric_limits<int>::max();
    for (const double value : values)
        if (value != 0)
            lowest = std::min(lowest, lowestBit(value));
    return lowest;
}

/// quotient * 2^exponent rounded to the nearest T, ties to even.
template <class T>
T rounded(ExactInteger::Quotient quotient, int exponent)
{
    using Limits = std::numeric_limits<T>;
    // Exponent of the smallest bit of a T.
    constexpr int smallest = Limits::min_exponent - Limits::digits;
    const std::uint64_t bits = quotient.whole << 1 | (quotient.remainder ? 1 : 0);
    --exponent;
    const int lowest =
        std::max(static_cast<int>(std::bit_width(bits)) + exponent - Limits::digits, smallest);
    const int dropped = lowest - exponent;
    assert(dropped > 0); // because the quotient has more bits than a T
    if (dropped >= 64)
        return T(0); // less than a quarter of the smallest T
    const std::uint64_t kept = bits >> dropped, rest = bits - (kept << dropped);
    const std::uint64_t half = std::uint64_t{1} << (dropped - 1);
    const bool up = rest > half || (rest == half && (kept & 1));
    return static_cast<T>(std::ldexp(static_cast<double>(kept + (up ? 1 : 0)), lowest));
}

} // namespace

std::strong_ordering orderInIntegers(double ax, double ay, double bx, double by, double x, double y)
{
    const int unit = commonExponent({ax, ay, bx, by, x, y});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const ExactInteger width = whole(bx) - whole(ax), height = whole(by) - whole(ay);
    const ExactInteger p = (whole(x) - whole(ax)) * height, q = (whole(y) - whole(ay)) * width;
    return (p - q).sign() * width.sign() * height.sign() <=> 0;
}

template <class T>
double crossingInIntegers(double ax, double ay, double bx, double by, double x)
{
    const int unit = commonExponent({ax, ay, bx, by, x});
    const auto whole = [unit](double value) { return ExactInteger(value, unit); };
    const ExactInteger width = whole(bx) - whole(ax);
    const ExactInteger numerator =
        whole(ay) * width + (whole(by) - whole(ay)) * (whole(x) - whole(ax));
    if (numerator.sign() == 0)
        return 0;
    // Scaled so that the quotient has 56 or 57 bits: more than a T has, with at least one bit for
    // rounding.
    const int scale = 56 - (numerator.bits() - width.bits());
    const auto quotient = ExactInteger::divide(scale > 0 ? numerator << scale : numerator,
                                               scale < 0 ? width << -scale : width);
    const T size = rounded<T>(quotient, unit - scale);
    return numerator.sign() * width.sign() * size + 0.0; // never -0
}

template double crossingInIntegers<double>(double, double, double, double, double);
template double crossingInIntegers<float>(double, double, double, double, double);

} // namespace clipping
