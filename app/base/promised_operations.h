// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

/// The operations that the paper's abstract counts: additions (with subtractions), multiplications,
/// divisions and comparisons. Negations are not counted.
inline std::uint64_t promisedOf(const clipping::OperationCounts& counts)
{
    return counts.additions + counts.multiplications + counts.divisions + counts.comparisons;
}

} // namespace app
