// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/integer.h"

#include <initializer_list>

namespace clipping {

/// The largest exponent such that all these numbers are integer multiples of 2^exponent.
int commonExponent(std::initializer_list<double> values);

/// numerator / denominator * 2^exponent, rounded to the nearest T, ties to even; never -0. The
/// result must be within T's range.
template <class T>
double nearestQuotient(const ExactInteger& numerator, const ExactInteger& denominator,
                       int exponent);

} // namespace clipping
