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

// Between the sorted numbers, as spreadsheets do it.
double quantile(std::span<const double> sorted, double share)
{
    const double position = share * double(sorted.size() - 1);
    const auto below = std::size_t(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return std::lerp(sorted[below], sorted[above], position - double(below));
}

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

std::vector<Standing> standings(std::span<const Summary> things)
{
    // Intervals that are linked by overlaps follow one another when sorted by where they begin.
    std::vector<std::size_t> order = sortedByMedian(things);
    std::ranges::stable_sort(order, {}, [&](std::size_t i) { return things[i].confidence.low; });
    std::vector<Standing> result(things.size());
    int ties = 0;
    for (std::size_t from = 0, to = 0; from < order.size(); from = to) {
        double high = things[order[from]].confidence.high;
        for (to = from + 1; to < order.size() && things[order[to]].confidence.low <= high; ++to)
            high = std::max(high, things[order[to]].confidence.high);
        if (to == from + 1)
            result[order[from]] = {int(from) + 1, std::nullopt};
        else
            for (const int tie = ties++;
                 const std::size_t i : std::span(order).subspan(from, to - from))
                result[i] = {std::nullopt, tie};
    }
    return result;
}

} // namespace app
