// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// The times of several variants or other things in the same rounds: one vector for each thing, all
/// of equal length, by round. At least one thing and one round.
using PairedRuns = std::span<const std::vector<double>>;

/// The family-wise error rate: among equal things, at most this share of experiments finds any
/// difference. The family is all pairs, so that it does not matter that the runs themselves decide
/// which thing has the lowest median.
inline constexpr double significance = 0.05;

/// A relative difference below this is practically equal, however significant it is.
inline constexpr double leastDifference = 0.01;

/// The number of rounds from which a test can find a difference among all pairs of `things`: the
/// smallest r with 2^(1 - r) < significance / pairs.
std::size_t leastRounds(std::size_t things);

/// The default number of rounds of an experiment: the paper's ten, or leastRounds if that is more.
std::size_t usualRounds(std::size_t things);

/// The outcome of a test of two things.
enum class Outcome : std::uint8_t {
    Different,        ///< significant, at least leastDifference, in the direction of the medians
    NotSignificant,   ///< no significant difference
    PracticallyEqual, ///< a significant difference below leastDifference
};

/// The test of one thing against another.
struct PairTest {
    double p = 1;     ///< corrected by Holm's method within its family of tests
    double ratio = 1; ///< time of the first ÷ time of the other: the median over rounds
    Outcome outcome = Outcome::NotSignificant;
};

/// Which things differ significantly in their times, by the exact two-sided signed-rank test,
/// paired by round. The tests of all pairs are one family, which decides everything that is said:
/// ranks, letters, and which thing is the fastest.
struct Ranking {
    std::size_t rounds = 0;
    bool told = false;              ///< there are leastRounds; else there are no ranks and letters
    std::vector<std::size_t> order; ///< indices of the things by ascending median
    std::vector<std::vector<PairTest>> pairs; ///< [i][j]: thing i against thing j
    /// Compact letter display: the largest groups in which no pair is Different. Two things share a
    /// group if and only if they are not Different. Sorted by median, as are the members of each
    /// group.
    std::vector<std::vector<std::size_t>> groups;
    /// 1 for the lowest median. Empty if any pair with another thing is not Different.
    std::vector<std::optional<int>> ranks;

    /// Whether the thing with the lowest median is the fastest: all others are Different from it.
    /// Then it has rank 1, and its letter alone.
    bool hasFastest() const;
    /// The test of a thing against the lowest median, one of all pairs.
    const PairTest& againstLowest(std::size_t thing) const;
    /// The thing with the lowest median, and those that are not Different from it by againstLowest,
    /// by median. A single leader is the fastest.
    std::vector<std::size_t> leaders() const;
    /// The groups that contain a thing, in their order.
    std::vector<std::size_t> groupsOf(std::size_t thing) const;
};
Ranking rankingOf(PairedRuns runs);

} // namespace app
