// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace app {

/// From low to high, both included.
struct Interval {
    double low, high;
};

/// The number at a share (0 to 1) of the way through sorted ones, of which there is one at least;
/// between two where it falls between, as spreadsheets do it.
double quantile(std::span<const double> sorted, double share);

/// What many times of one thing say.
struct Summary {
    double median = 0;
    double spread = 0; ///< between the quartiles
    double mean = 0;   ///< what the paper used; one slow run moves it
    /// Where the middle lies with 95 % confidence: between two of the sorted times (binomial, so
    /// nothing is assumed of how they are spread) from six times on, with three to five by
    /// Student's t of their logarithms, so that it lies above 0 as times do. Two times, or one, say
    /// nothing: the whole axis; nor do fewer than six if not all are above 0. Two intervals that
    /// overlap say nothing of whether two things differ: ranking.h tests that.
    Interval confidence{};
};

/// Of at least one number.
Summary summaryOf(std::span<const double> times);

/// Indices of the things from the lowest median to the highest.
std::vector<std::size_t> sortedByMedian(std::span<const Summary> things);

} // namespace app
