// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/ranking.h"

#include "app/base/statistics.h"
#include "app/experiment/signed_rank.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace app {
namespace {

constexpr std::size_t paperRounds = 10;

/// The ratio of two times. Two zeros are equal.
double ratioOf(double one, double other) { return one == other ? 1 : one / other; }

PairTest uncorrected(const std::vector<double>& one, const std::vector<double>& other)
{
    std::vector<double> differences, ratios;
    for (std::size_t r = 0; r < one.size(); ++r) {
        differences.push_back(one[r] - other[r]);
        ratios.push_back(ratioOf(one[r], other[r]));
    }
    std::ranges::sort(ratios);
    return {.p = signedRankP(differences), .ratio = quantile(ratios, 0.5)};
}

/// Holm's method: multiplies the smallest p by the number of tests, the next by one less ...
void correct(std::span<PairTest* const> family)
{
    std::vector<PairTest*> tests(family.begin(), family.end());
    std::ranges::sort(tests, {}, &PairTest::p);
    double least = 0;
    for (std::size_t i = 0; i < tests.size(); ++i) {
        least = std::max(least, std::min(1.0, double(tests.size() - i) * tests[i]->p));
        tests[i]->p = least;
    }
}

/// The outcome of a corrected test of the thing with the higher median against the other one.
Outcome outcomeOf(const PairTest& test)
{
    if (test.p >= significance)
        return Outcome::NotSignificant;
    if (std::abs(test.ratio - 1) < leastDifference)
        return Outcome::PracticallyEqual;
    return test.ratio > 1 ? Outcome::Different : Outcome::NotSignificant;
}

PairTest theOtherWayRound(PairTest test)
{
    test.ratio = ratioOf(1, test.ratio);
    return test;
}

void testPairs(Ranking& ranking, PairedRuns runs)
{
    std::vector<PairTest*> family;
    const auto eachPair = [&](auto visit) { // the higher median first
        for (std::size_t a = 1; a < ranking.order.size(); ++a)
            for (std::size_t b = 0; b < a; ++b)
                visit(ranking.order[a], ranking.order[b]);
    };
    eachPair([&](std::size_t i, std::size_t j) {
        ranking.pairs[i][j] = uncorrected(runs[i], runs[j]);
        family.push_back(&ranking.pairs[i][j]);
    });
    correct(family);
    eachPair([&](std::size_t i, std::size_t j) {
        ranking.pairs[i][j].outcome = outcomeOf(ranking.pairs[i][j]);
        ranking.pairs[j][i] = theOtherWayRound(ranking.pairs[i][j]);
    });
}

using Places = std::vector<std::size_t>; // positions in the order of medians

/// Removes groups that another group contains.
void absorb(std::vector<Places>& groups)
{
    std::ranges::sort(groups, std::ranges::greater(), &Places::size);
    std::vector<Places> kept;
    for (Places& group : groups)
        if (std::ranges::none_of(
                kept, [&](const Places& larger) { return std::ranges::includes(larger, group); }))
            kept.push_back(std::move(group));
    groups = std::move(kept);
}

/// Splits each group that contains both a and b into two, each without one of them.
std::vector<Places> split(std::vector<Places> groups, std::size_t a, std::size_t b)
{
    std::vector<Places> all;
    for (Places& group : groups) {
        if (!std::ranges::binary_search(group, a) || !std::ranges::binary_search(group, b)) {
            all.push_back(std::move(group));
            continue;
        }
        for (const std::size_t without : {a, b}) {
            all.push_back(group);
            std::erase(all.back(), without);
        }
    }
    return all;
}

/// Insert and absorb (Piepho 2004): starts with one group of all things; each pair that differs
/// splits the groups that contain both.
std::vector<Places> groupsOf(const Ranking& ranking)
{
    Places all(ranking.order.size());
    std::iota(all.begin(), all.end(), std::size_t(0));
    std::vector<Places> groups{all};
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = 0; b < a; ++b) {
            if (ranking.pairs[ranking.order[a]][ranking.order[b]].outcome != Outcome::Different)
                continue;
            groups = split(std::move(groups), a, b);
            absorb(groups);
        }
    std::ranges::sort(groups);
    return groups;
}

void rank(Ranking& ranking)
{
    for (std::size_t place = 0; place < ranking.order.size(); ++place) {
        const std::size_t i = ranking.order[place];
        if (std::ranges::all_of(ranking.order, [&](std::size_t j) {
                return i == j || ranking.pairs[i][j].outcome == Outcome::Different;
            }))
            ranking.ranks[i] = int(place) + 1;
    }
}

std::vector<std::size_t> orderOf(PairedRuns runs)
{
    std::vector<Summary> summaries;
    for (const auto& times : runs)
        summaries.push_back(summaryOf(times));
    return sortedByMedian(summaries);
}

} // namespace

std::size_t leastRounds(std::size_t things)
{
    const double pairs = double(things) * (double(things) - 1) / 2;
    std::size_t rounds = 1;
    while (pairs > 0 && std::exp2(1 - double(rounds)) >= significance / pairs)
        ++rounds;
    return rounds;
}

std::size_t usualRounds(std::size_t things) { return std::max(paperRounds, leastRounds(things)); }

Ranking rankingOf(PairedRuns runs)
{
    assert(!runs.empty());
    assert(std::ranges::all_of(
        runs, [&](const auto& times) { return times.size() == runs.front().size(); }));
    const std::size_t n = runs.size();
    Ranking ranking{.rounds = runs.front().size(),
                    .told = runs.front().size() >= leastRounds(n),
                    .order = orderOf(runs),
                    .pairs = std::vector(n, std::vector<PairTest>(n)),
                    .groups = {},
                    .ranks = std::vector<std::optional<int>>(n)};
    testPairs(ranking, runs);
    if (!ranking.told)
        return ranking;
    rank(ranking);
    for (Places& group : groupsOf(ranking)) {
        for (std::size_t& place : group)
            place = ranking.order[place];
        ranking.groups.push_back(std::move(group));
    }
    return ranking;
}

bool Ranking::hasFastest() const
{
    return std::ranges::all_of(order, [&](std::size_t i) {
        return i == order.front() || againstLowest(i).outcome == Outcome::Different;
    });
}

const PairTest& Ranking::againstLowest(std::size_t thing) const
{
    return pairs[thing][order.front()];
}

std::vector<std::size_t> Ranking::leaders() const
{
    std::vector<std::size_t> first = order;
    std::erase_if(first,
                  [&](std::size_t i) { return againstLowest(i).outcome == Outcome::Different; });
    return first;
}

std::vector<std::size_t> Ranking::groupsOf(std::size_t thing) const
{
    std::vector<std::size_t> all;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (std::ranges::find(groups[g], thing) != groups[g].end())
            all.push_back(g);
    return all;
}

} // namespace app
