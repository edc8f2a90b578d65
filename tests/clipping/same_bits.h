// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

/// Whether two values have the same bits: NaN equals itself, and -0 differs from 0. For types
/// without padding.
template <class T>
bool sameBits(const T& p, const T& q)
{
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): not the numbers are compared
    return std::memcmp(&p, &q, sizeof p) == 0;
}
