// SPDX-License-Identifier: MIT
#include "clipping/exact/quotient.h"

#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>

namespace clipping {
namespace {

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

int commonExponent(std::initializer_list<double> values)
{
    int lowest = std::numeric_limits<int>::max();
    for (const double value : values)
        if (value != 0)
            lowest = std::min(lowest, lowestBit(value));
    return lowest;
}

template <class T>
double nearestQuotient(const ExactInteger& numerator, const ExactInteger& denominator, int exponent)
{
    if (numerator.sign() == 0)
        return 0;
    // Scaled so that the quotient has 56 or 57 bits: more than a T has, with at least one bit for
    // rounding.
    const int scale = 56 - (numerator.bits() - denominator.bits());
    const auto quotient = ExactInteger::divide(scale > 0 ? numerator << scale : numerator,
                                               scale < 0 ? denominator << -scale : denominator);
    const T size = rounded<T>(quotient, exponent - scale);
    return numerator.sign() * denominator.sign() * size + 0.0; // never -0
}

template double nearestQuotient<double>(const ExactInteger&, const ExactInteger&, int);
template double nearestQuotient<float>(const ExactInteger&, const ExactInteger&, int);

} // namespace clipping
