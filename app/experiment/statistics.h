// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace app {

/// From low to high, both included.
struct Interval {
    double low, high;
    bool overlaps(const Interval& other) const { return low <= other.high && other.low <= high; }
};

/// The number at a share (0 to 1) of the way through sorted ones, of which there is one at least;
/// between two where it falls between, as spreadsheets do it.
double quantile(std::span<const double> sorted, double share);

/// What many measurements of one thing say.
struct Summary {
    double median = 0;
    double spread = 0; ///< between the quartiles
    double mean = 0;   ///< what the paper used; one slow run moves it
    /// Where the middle lies with 95 % confidence: between two of the sorted numbers (binomial, so
    /// nothing is assumed of how they are spread) from six numbers on, with fewer by Student's t.
    /// One number says nothing: the whole axis.
    Interval confidence{};
};

/// Of at least one number.
Summary summaryOf(std::span<const double> numbers);

/// Indices of the things from the lowest median to the highest.
std::vector<std::size_t> sortedByMedian(std::span<const Summary> things);

/// The largest groups of two things or more in which every confidence interval overlaps every
/// other: within a group it is too close to call. One thing may be in several, so that two who
/// share no group differ even where a third ties with both. Each group is sorted by median, and so
/// are the groups.
std::vector<std::vector<std::size_t>> tieGroups(std::span<const Summary> things);

/// The place of one thing among others.
struct Standing {
    std::optional<int> rank; ///< 1 for the fastest; none where it is too close to call
    std::vector<int> ties{}; ///< of which of tieGroups it is, then
};

/// The places by median, the lowest first. A thing has a rank if its confidence interval overlaps
/// that of no other; two things share a tie if theirs overlap.
std::vector<Standing> standings(std::span<const Summary> things);

} // namespace app
