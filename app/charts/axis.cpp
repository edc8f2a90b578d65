// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

void take(std::vector<double>&, const std::monostate&) {}

void take(std::vector<double>& values, const Bar& bar)
{
    values.push_back(bar.length());
    if (bar.whiskers)
        values.insert(values.end(), {bar.whiskers->low, bar.whiskers->high});
}

void take(std::vector<double>& values, const Box& box)
{
    values.insert(values.end(), {box.whiskers.low, box.whiskers.high});
    values.insert(values.end(), box.outliers.begin(), box.outliers.end());
}

/// All that has to find a place.
Interval reachOf(const Chart& chart)
{
    std::vector<double> values;
    if (chart.reference)
        values.push_back(*chart.reference);
    for (const ChartRow& row : chart.rows) {
        for (const Figure& figure : row.figures)
            std::visit([&](const auto& f) { take(values, f); }, figure);
        if (row.other)
            values.push_back(*row.other);
    }
    std::erase_if(values, [](double x) { return !std::isfinite(x); });
    if (values.empty())
        return {0, 1};
    const auto [low, high] = std::ranges::minmax(values);
    return {chart.fromZero ? std::min(low, 0.0) : low, high};
}

/// 1, 2, 2.5 or 5 times a power of ten, and the decimals that its multiples need.
std::pair<double, int> roundStep(double atLeast)
{
    const double power = std::floor(std::log10(atLeast));
    for (const double factor : {1.0, 2.0, 2.5, 5.0, 10.0}) {
        const double step = factor * std::pow(10, power);
        if (step >= atLeast * (1 - 1e-9))
            return {step, std::max(0, int(-power) + (factor == 2.5 ? 1 : factor == 10 ? -1 : 0))};
    }
    return {atLeast, 0};
}

} // namespace

Axis axisOf(const Chart& chart, int ticks)
{
    Interval range = reachOf(chart);
    const double size = range.high > range.low ? range.high - range.low : 1;
    range.high = range.low + size * 1.03;
    if (!chart.fromZero)
        range.low -= size * 0.03;
    const auto [step, decimals] = roundStep((range.high - range.low) / std::max(ticks, 1));
    Axis axis{range, {}, decimals};
    const double first = std::ceil(range.low / step - 1e-9);
    for (int i = 0; (first + i) * step <= range.high; ++i)
        axis.ticks.push_back((first + i) * step);
    return axis;
}

} // namespace app
