// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/statistics.h"

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

/// Uses logarithms: a time is as likely to be doubled as to be halved, and never below 0.
Interval studentsInterval(std::span<const double> times)
{
    // The 97.5 % points of t with 2, 3 and 4 degrees of freedom.
    constexpr std::array t{4.303, 3.182, 2.776};
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (times.size() < 3 || std::ranges::any_of(times, [](double time) { return time <= 0; }))
        return {-infinity, infinity};
    std::vector<double> logarithms;
    for (const double time : times)
        logarithms.push_back(std::log(time));
    const double mean = meanOf(logarithms), n = double(times.size());
    double squares = 0;
    for (const double logarithm : logarithms)
        squares += (logarithm - mean) * (logarithm - mean);
    const double half = t[times.size() - 3] * std::sqrt(squares / (n - 1) / n);
    return {std::exp(mean - half), std::exp(mean + half)};
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

Summary summaryOf(std::span<const double> times)
{
    assert(!times.empty());
    std::vector<double> sorted(times.begin(), times.end());
    std::ranges::sort(sorted);
    return {.median = quantile(sorted, 0.5),
            .spread = quantile(sorted, 0.75) - quantile(sorted, 0.25),
            .mean = meanOf(times),
            .confidence = times.size() < 6 ? studentsInterval(sorted) : binomialInterval(sorted)};
}

std::vector<std::size_t> sortedByMedian(std::span<const Summary> things)
{
    std::vector<std::size_t> order(things.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return things[i].median; });
    return order;
}

} // namespace app
