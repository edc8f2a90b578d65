// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/rational.hpp>
#include <cmath>
#include <cstdint>

/// Fractions of any length. (Boost's own cpp_rational refers to temporaries, which clang's analyzer
/// does not like.)
using Rational =
    boost::rational<boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                                  boost::multiprecision::et_off>>;

/// The exact value of a finite float or double.
inline Rational rational(double x)
{
    using Whole = Rational::int_type;
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(x, &exponent), 53));
    const int shift = exponent - 53;
    return shift < 0 ? Rational(mantissa, Whole(1) << -shift) : Rational(Whole(mantissa) << shift);
}
