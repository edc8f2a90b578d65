// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace app {

/// The closed interval from low to high.
struct Interval {
    double low, high;
};

/// The quantile of sorted numbers (at least one) at `share` (0 to 1), linearly interpolated as
/// spreadsheets do.
double quantile(std::span<const double> sorted, double share);

/// Summarizes repeated times of one thing.
struct Summary {
    double median = 0;
    double spread = 0; ///< interquartile range
    double mean = 0;   ///< as used in the paper; a single slow run moves it
    /// The 95 % confidence interval of the median. From six times on it lies between two of the
    /// sorted times (binomial, so no distribution is assumed). For three to five times it uses
    /// Student's t on their logarithms, so that it stays above 0. For one or two times, or fewer
    /// than six that are not all above 0, it is the whole axis. Overlapping intervals do not show
    /// that two things are equal: ranking.h tests that.
    Interval confidence{};
};

/// `times` holds at least one number.
Summary summaryOf(std::span<const double> times);

/// Indices of `things`, from the lowest median to the highest.
std::vector<std::size_t> sortedByMedian(std::span<const Summary> things);

} // namespace app
