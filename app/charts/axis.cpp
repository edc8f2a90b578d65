// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

/// The values of a panel: all of them, and those of the bars.
struct Values {
    std::vector<double> all, bars;
};

void take(Values&, const std::monostate&) {}

void take(Values& values, const Bar& bar)
{
    values.bars.push_back(bar.length());
    values.all.push_back(bar.length());
    if (bar.whiskers)
        values.all.insert(values.all.end(), {bar.whiskers->low, bar.whiskers->high});
}

void take(Values& values, const Box& box)
{
    values.all.insert(values.all.end(), {box.whiskers.low, box.whiskers.high});
    values.all.insert(values.all.end(), box.outliers.begin(), box.outliers.end());
}

Values valuesOf(const Chart& chart, std::size_t panel)
{
    Values values;
    for (const ChartRow& row : chart.rows) {
        for (std::size_t p = 0; p < row.figures.size(); ++p)
            if (p == panel || chart.oneScale)
                std::visit([&](const auto& f) { take(values, f); }, row.figures[p]);
        if (row.other && (panel == 0 || chart.oneScale))
            values.all.push_back(*row.other);
    }
    if (chart.reference)
        values.all.push_back(*chart.reference);
    std::erase_if(values.all, [](double x) { return !std::isfinite(x); });
    return values;
}

/// The length beyond which a bar is broken; empty if no bar is far longer than most.
std::optional<double> limitOf(std::vector<double> bars)
{
    constexpr double far = 4; // medians
    if (bars.empty())
        return std::nullopt;
    std::ranges::sort(bars);
    const double limit = far * bars[bars.size() / 2];
    const auto broken = std::ranges::count_if(bars, [&](double x) { return x > limit; });
    const bool few = std::size_t(broken) * 5 <= bars.size();
    return limit > 0 && broken > 0 && few ? std::optional(limit) : std::nullopt;
}

/// The range of everything that is shown in full, with a margin.
Interval rangeOf(const Chart& chart, std::size_t panel)
{
    Values values = valuesOf(chart, panel);
    const auto limit = limitOf(values.bars);
    if (limit)
        std::erase_if(values.all, [&](double x) { return x > *limit; });
    if (values.all.empty())
        return {0, 1};
    const bool fromZero = chart.panels[panel].fromZero;
    const auto [least, most] = std::ranges::minmax(values.all);
    const double low = fromZero ? std::min(least, 0.0) : least,
                 size = most > low ? most - low : std::max(std::abs(low), 1.0);
    return {fromZero ? low : low - size * 0.03, low + size * (limit ? 1.2 : 1.03)};
}

/// 1, 2, 2.5 or 5 times a power of ten, and the number of decimals of its multiples.
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

Axis axisOf(const Chart& chart, std::size_t panel, double ticks)
{
    const Interval range = rangeOf(chart, panel);
    const auto [step, decimals] = roundStep((range.high - range.low) / std::max(ticks, 1.0));
    Axis axis{range, {}, decimals};
    const double first = std::ceil(range.low / step - 1e-9);
    for (int i = 0; (first + i) * step <= range.high; ++i)
        axis.ticks.push_back((first + i) * step);
    return axis;
}

bool isBroken(const Chart& chart)
{
    for (std::size_t p = 0; p < chart.panels.size(); ++p)
        if (limitOf(valuesOf(chart, p).bars))
            return true;
    return false;
}

} // namespace app
