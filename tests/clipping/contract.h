// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <string>

#include "tests/clipping/inputs.h"
#include "tests/clipping/oracle.h"

/// The input in C++ source and hexadecimal floating point, exactly.
std::string exactly(const Input& input);

/// The truth about an input that is finite and whose window is in order.
std::optional<oracle::Part> truthOf(const Input& input);

/// How a result breaks the contract of clipping/algorithm.h with this k; empty if it keeps it.
std::string fault(const std::optional<clipping::Segment>& result, const Input& input,
                  const std::optional<oracle::Part>& truth, double k);

/// Whether two numbers are the same bits.
bool sameBits(const clipping::Segment& s, const clipping::Segment& t);

/// How far a result is off the truth, in ulps of the largest |coordinate|; 0 unless both are seen.
double ulpsOff(const std::optional<clipping::Segment>& result, const Input& input,
               const std::optional<oracle::Part>& truth);
