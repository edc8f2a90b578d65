// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace app {

/// Up to so many differences signedRankP is exact, to some units in the last place. Beyond, it is
/// the normal approximation with continuity correction, which then is off by less than 0.001.
inline constexpr std::size_t mostExactDifferences = 200;

/// p of Wilcoxon's signed-rank test, two-sided, of paired differences: the share of all ways to
/// give the differences signs that lie at least as far from balance as the signs they have. Equal
/// sizes share the mean of their ranks. Zeros are treated as Pratt does: they take part when ranks
/// are given, so that they push the others up, and then drop out. 1 if there are only zeros.
/// Every number is finite.
double signedRankP(std::span<const double> differences);

} // namespace app
