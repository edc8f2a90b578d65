// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/legend.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace app {

namespace {

Interval rangeOf(const CostMap& map)
{
    if (!map.plan.measure->isTime()) {
        const auto [least, most] = std::ranges::minmax_element(map.values);
        return {*least, *most};
    }
    std::vector<double> sorted(map.values.begin(), map.values.end());
    std::ranges::sort(sorted);
    return {quantile(sorted, 0.01), quantile(sorted, 0.99)};
}

/// 1, 2 or 5 times a power of ten, so that there are about five steps.
double stepOf(const Interval& range, bool whole)
{
    const double wanted = (range.high - range.low) / 5;
    const double power = std::pow(10, std::floor(std::log10(wanted)));
    double step = 10 * power;
    for (const double times : {5., 2., 1.})
        if (times * power >= wanted)
            step = times * power;
    return whole ? std::max(1., step) : step;
}

std::vector<double> ticksOf(const Interval& range, bool whole)
{
    if (!(range.high > range.low))
        return {range.low};
    const double step = stepOf(range, whole);
    std::vector<double> ticks{range.low};
    for (double n = std::ceil(range.low / step); n * step < range.high; ++n)
        if (n * step - range.low > step / 2 && range.high - n * step > step / 2)
            ticks.push_back(n * step);
    ticks.push_back(range.high);
    return ticks;
}

} // namespace

double CostLegend::shareOf(double cost) const
{
    return range.high > range.low
               ? std::clamp((cost - range.low) / (range.high - range.low), 0., 1.)
               : 0;
}

CostLegend legendOf(const CostMap& map)
{
    CostLegend legend;
    legend.range = rangeOf(map);
    legend.ticks = ticksOf(legend.range, !map.plan.measure->isTime());
    std::map<std::uint32_t, std::size_t> counts;
    for (const std::uint32_t cheapest : map.cheapest)
        ++counts[cheapest];
    for (const auto& [cheapest, cells] : counts)
        legend.shares.push_back({cheapest, cells});
    std::ranges::stable_sort(legend.shares, std::greater{}, &CostLegend::Share::cells);
    return legend;
}

} // namespace app
