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

/// The place of one thing among others: a rank, or a tie with those that share its number.
struct Standing {
    std::optional<int> rank; ///< 1 for the fastest; none where it is too close to call
    std::optional<int> tie;  ///< from 0, then
};

/// The places by median, the lowest first. Things whose confidence intervals overlap, or are linked
/// by others that overlap, are too close to call, and none of them has a rank.
std::vector<Standing> standings(std::span<const Summary> things);

/// Indices of the things from the lowest median to the highest.
std::vector<std::size_t> sortedByMedian(std::span<const Summary> things);

} // namespace app
