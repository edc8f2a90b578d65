// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/statistics.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

namespace app {
namespace {

double meanOf(std::span<const double> numbers)
{
    return std::accumulate(numbers.begin(), numbers.end(), 0.0) / double(numbers.size());
}

Interval studentsInterval(std::span<const double> numbers)
{
    // The 97.5 % points of t with 1, 2, ... degrees of freedom.
    constexpr std::array t{12.706, 4.303, 3.182, 2.776};
    if (numbers.size() < 2)
        return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const double mean = meanOf(numbers), n = double(numbers.size());
    double squares = 0;
    for (const double number : numbers)
        squares += (number - mean) * (number - mean);
    const double half = t[numbers.size() - 2] * std::sqrt(squares / (n - 1) / n);
    return {mean - half, mean + half};
}

/// The true median lies below the k-th of n sorted numbers with the probability of fewer than k
/// heads in n tosses: the largest k for which that is at most 2.5 %.
Interval binomialInterval(std::span<const double> sorted)
{
    const double n = double(sorted.size());
    double fewer = 0;
    std::size_t k = 0;
    for (;; ++k) {
        const double i = double(k); // log of (n over k) / 2^n
        const double logOf = std::lgamma(n + 1) - std::lgamma(i + 1) - std::lgamma(n - i + 1);
        fewer += std::exp(logOf - n * std::log(2.0));
        if (fewer > 0.025)
            break;
    }
    return {sorted[k - 1], sorted[sorted.size() - k]};
}

} // namespace

double quantile(std::span<const double> sorted, double share)
{
    const double position = share * double(sorted.size() - 1);
    const auto below = std::size_t(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - double(below));
}

Summary summaryOf(std::span<const double> numbers)
{
    assert(!numbers.empty());
    std::vector<double> sorted(numbers.begin(), numbers.end());
    std::ranges::sort(sorted);
    return {.median = quantile(sorted, 0.5),
            .spread = quantile(sorted, 0.75) - quantile(sorted, 0.25),
            .mean = meanOf(numbers),
            .confidence = numbers.size() < 6 ? studentsInterval(sorted) : binomialInterval(sorted)};
}

std::vector<std::size_t> sortedByMedian(std::span<const Summary> things)
{
    std::vector<std::size_t> order(things.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return things[i].median; });
    return order;
}

std::vector<std::vector<std::size_t>> tieGroups(std::span<const Summary> things)
{
    // Intervals that overlap pairwise have a point in common, the highest of their lows; so those
    // that hold the low of one of them are all candidates.
    const auto order = sortedByMedian(things);
    std::vector<std::vector<std::size_t>> groups; // of places in that order
    for (const Summary& thing : things) {
        std::vector<std::size_t> group;
        for (std::size_t place = 0; place < order.size(); ++place)
            if (const Interval& one = things[order[place]].confidence;
                one.low <= thing.confidence.low && thing.confidence.low <= one.high)
                group.push_back(place);
        const auto within = [](const auto& larger, const auto& smaller) {
            return std::ranges::includes(larger, smaller);
        };
        if (group.size() < 2
            || std::ranges::any_of(groups, [&](const auto& other) { return within(other, group); }))
            continue;
        std::erase_if(groups, [&](const auto& other) { return within(group, other); });
        groups.push_back(std::move(group));
    }
    std::ranges::sort(groups);
    for (auto& group : groups)
        for (std::size_t& place : group)
            place = order[place];
    return groups;
}

std::vector<Standing> standings(std::span<const Summary> things)
{
    std::vector<Standing> result(things.size());
    const auto groups = tieGroups(things);
    for (std::size_t g = 0; g < groups.size(); ++g)
        for (const std::size_t i : groups[g])
            result[i].ties.push_back(int(g));
    const auto order = sortedByMedian(things);
    for (std::size_t place = 0; place < order.size(); ++place)
        if (Standing& standing = result[order[place]]; standing.ties.empty())
            standing.rank = int(place) + 1;
    return result;
}

} // namespace app
