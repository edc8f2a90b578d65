// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>

/// Whether two values are the same bits: NaN is itself, and -0 is not 0. For what has no padding.
template <class T>
bool sameBits(const T& p, const T& q)
{
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): not the numbers are compared
    return std::memcmp(&p, &q, sizeof p) == 0;
}
