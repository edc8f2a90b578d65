// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/exact/integer.h"

#include <initializer_list>

namespace clipping {

/// The largest exponent such that all these finite numbers are integer multiples of 2^exponent.
/// Numbers that are 0 do not count; if all are 0, the result is the largest int.
int commonExponent(std::initializer_list<double> values);

/// numerator / denominator * 2^exponent, rounded once to the nearest T (double or float), ties to
/// even; never -0. The denominator must not be 0, and the result must be within T's range.
template <class T>
T nearest(const ExactInteger& numerator, const ExactInteger& denominator, int exponent);

} // namespace clipping
