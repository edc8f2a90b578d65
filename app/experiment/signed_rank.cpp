// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/signed_rank.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

namespace app {
namespace {

/// Ranks are doubled, so that the mean of two neighbours is an integer.
struct SignedRanks {
    std::vector<std::size_t> ranks; ///< of the nonzero differences
    std::size_t positive = 0;       ///< the sum of the ranks of positive differences
    std::size_t total = 0;          ///< the sum of all ranks
};

SignedRanks signedRanksOf(std::span<const double> differences)
{
    std::vector<double> sorted(differences.begin(), differences.end());
    std::ranges::sort(sorted, {}, [](double x) { return std::abs(x); });
    SignedRanks result;
    for (std::size_t first = 0, next = 0; first < sorted.size(); first = next) {
        while (next < sorted.size() && std::abs(sorted[next]) == std::abs(sorted[first]))
            ++next;
        const std::size_t rank = first + 1 + next; // twice the mean of first + 1 ... next
        for (std::size_t i = first; i < next && sorted[i] != 0; ++i) {
            result.ranks.push_back(rank);
            result.positive += sorted[i] > 0 ? rank : 0;
            result.total += rank;
        }
    }
    return result;
}

/// The share of all subsets of ranks whose sum is at most `sum`.
double shareUpTo(std::size_t sum, std::span<const std::size_t> ranks)
{
    std::vector<double> shares(sum + 1); // for each sum, from the ranks so far
    shares[0] = 1;
    for (const std::size_t rank : ranks)
        for (std::size_t s = shares.size(); s-- > 0;)
            shares[s] = (shares[s] + (s >= rank ? shares[s - rank] : 0)) / 2;
    return std::accumulate(shares.begin(), shares.end(), 0.0);
}

double normalP(const SignedRanks& signedRanks, double sum)
{
    double squares = 0;
    for (const std::size_t rank : signedRanks.ranks)
        squares += double(rank) * double(rank);
    const double away = double(signedRanks.total) / 2 - sum - 1, deviation = std::sqrt(squares) / 2;
    return std::erfc(std::max(away, 0.0) / deviation / std::numbers::sqrt2);
}

} // namespace

double signedRankP(std::span<const double> differences)
{
    const SignedRanks all = signedRanksOf(differences);
    const std::size_t smaller = std::min(all.positive, all.total - all.positive);
    if (2 * smaller == all.total)
        return 1;
    return std::min(1.0, all.ranks.size() > mostExactDifferences
                             ? normalP(all, double(smaller))
                             : 2 * shareUpTo(smaller, all.ranks));
}

} // namespace app
