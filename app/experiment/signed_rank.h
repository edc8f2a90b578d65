// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace app {

/// Up to this many differences signedRankP is exact, to some units in the last place. Beyond, it
/// uses the normal approximation with continuity correction, whose error is then below 0.001.
inline constexpr std::size_t mostExactDifferences = 200;

/// The two-sided p of Wilcoxon's signed-rank test for paired differences: the share of all sign
/// assignments that are at least as far from balance as the given signs. Equal absolute values
/// share the mean of their ranks. Zeros are treated by Pratt's method: they are ranked, which
/// raises the other ranks, and then dropped. 1 if there are only zeros. All differences must be
/// finite.
double signedRankP(std::span<const double> differences);

} // namespace app
