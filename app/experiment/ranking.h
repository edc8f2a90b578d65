// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace app {

/// Times of things that took part in the same rounds: a vector a thing, all of one length, round by
/// round. At least one thing and one round.
using PairedRuns = std::span<const std::vector<double>>;

/// Among equal things, so many of all families of tests at most find any difference, if what is
/// tested does not depend on the runs: so with all pairs, and with the claim that one thing is the
/// fastest. The tests against the lowest median, which is chosen by these runs, do not keep to it
/// one by one: with eleven equal things some p is below it in about one of ten experiments.
inline constexpr double significance = 0.05;

/// Below this share a difference counts as practically equal, however significant it is.
inline constexpr double leastDifference = 0.01;

/// From how many rounds on a test can find a difference among all pairs of so many things: the
/// smallest r with 2^(1 - r) < significance / pairs.
std::size_t leastRounds(std::size_t things);

/// How many rounds an experiment takes by default: the paper's ten, or leastRounds.
std::size_t usualRounds(std::size_t things);

/// The outcome of a test of two things.
enum class Outcome : std::uint8_t {
    Different,        ///< significantly, by leastDifference or more, and as the medians say
    NotSignificant,   ///< no significant difference
    PracticallyEqual, ///< a significant difference that is smaller than leastDifference
};

/// One thing against another.
struct PairTest {
    double p = 1;     ///< corrected by Holm's method for the tests of its family
    double ratio = 1; ///< of the one's time to the other's in the same round: the median of rounds
    Outcome outcome = Outcome::NotSignificant;
};

/// Things by their times: which differ from which. By the exact two-sided signed-rank test, paired
/// by round. All pairs are one family of tests, on which ranks and letters are based. The thing
/// with the lowest median against each other one is another family, which decides whether it is the
/// fastest: it is if all of these tests are Different.
struct Ranking {
    std::size_t rounds = 0;
    bool told = false;              ///< there are leastRounds; else there are no ranks and letters
    std::vector<std::size_t> order; ///< indices of the things by median, the lowest first
    std::vector<PairTest> fastest;  ///< each thing against order.front()
    std::vector<std::vector<PairTest>> pairs; ///< [i][j]: thing i against thing j
    /// Compact letter display: the largest groups in which no pair is Different. Two things share a
    /// group if and only if they are not. Sorted by median within and among themselves.
    std::vector<std::vector<std::size_t>> groups;
    /// 1 for the lowest median. None where a pair with another thing is not Different.
    std::vector<std::optional<int>> ranks;

    /// Whether the thing with the lowest median is the fastest: all others are Different from it.
    bool hasFastest() const;
    /// The test that counts for a thing and the one with the lowest median: of `fastest` if that is
    /// the fastest, otherwise of all pairs.
    const PairTest& againstLowest(std::size_t thing) const;
    /// The thing with the lowest median, and those that are not Different from it, by median; by
    /// againstLowest. One alone is the fastest.
    std::vector<std::size_t> leaders() const;
    /// Of which groups a thing is, in their order.
    std::vector<std::size_t> groupsOf(std::size_t thing) const;
};
Ranking rankingOf(PairedRuns runs);

} // namespace app
