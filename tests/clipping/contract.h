// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <string>
#include <type_traits>

#include "tests/clipping/inputs.h"
#include "tests/clipping/oracle.h"
#include "tests/clipping/same_bits.h"

/// All of these for two and for three dimensions.
template <glm::length_t N>
using Truth =
    std::optional<oracle::BasicPart<std::conditional_t<N == 2, oracle::Point, oracle::Point3>>>;

/// The input in C++ source and hexadecimal floating point, exactly.
template <glm::length_t N>
std::string exactly(const BasicInput<N>& input);
inline std::string exactly(const Input& input) { return exactly<2>(input); }

/// The exact result for a finite input whose window is not inverted.
template <glm::length_t N>
Truth<N> truthOf(const BasicInput<N>& input);

/// How a result breaks the contract of clipping/algorithm.h with this k; empty if it does not.
template <glm::length_t N>
std::string fault(const std::optional<clipping::BasicSegment<double, N>>& result,
                  const BasicInput<N>& input, const Truth<N>& truth, double k,
                  oracle::Number number = oracle::Number::Double);

/// The error of a result in ulps of the largest |coordinate|; 0 unless both are visible.
template <glm::length_t N>
double ulpsOff(const std::optional<clipping::BasicSegment<double, N>>& result,
               const BasicInput<N>& input, const Truth<N>& truth,
               oracle::Number number = oracle::Number::Double);
