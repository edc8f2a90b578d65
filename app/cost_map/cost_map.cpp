// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/cost_map.h"

#include "app/base/clock.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace app {

using clipping::Segment;
using clipping::Window;

namespace {

constexpr std::size_t timedLines = 64, timedRounds = 5;
constexpr double noise = 1.1; // smaller ratios of times count as equal

/// The time of one round, after which everything is in the caches.
double roundOf(const Variant& variant, std::span<const Segment> lines, const Window& window,
               std::span<clipping::Clipped> out, const Clock& clock)
{
    const double before = clock.nanoseconds();
    clipAll(variant, lines, window, out);
    return (clock.nanoseconds() - before) / double(lines.size());
}

double nanosecondsOf(const Variant& variant, const Segment& line, const Window& window)
{
    static const Clock clock = processorClock();
    std::array<Segment, timedLines> lines;
    lines.fill(line);
    std::array<clipping::Clipped, timedLines> out;
    std::array<double, timedRounds> rounds{};
    roundOf(variant, lines, window, out, clock);
    for (double& round : rounds)
        round = roundOf(variant, lines, window, out, clock);
    std::ranges::nth_element(rounds, rounds.begin() + timedRounds / 2);
    return rounds[timedRounds / 2];
}

} // namespace

Point CostPlan::middleOf(int column, int row) const
{
    const Point share((column + 0.5) / columns, (row + 0.5) / rows);
    return area.min + (area.max - area.min) * share;
}

Segment CostPlan::lineTo(const Point& there) const
{
    return end == FixedEnd::End1 ? Segment{fixed, there} : Segment{there, fixed};
}

std::vector<Variant> costVariants(clipping::Form form)
{
    std::vector<Variant> all;
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        if (clipping::functionsOf(algorithm, form))
            all.push_back({&algorithm, form});
    return all;
}

Window areaAround(const Window& window)
{
    const Point size = window.max - window.min;
    const double some = std::max(
        {size.x, size.y, std::abs(window.max.x) * 1e-6, std::abs(window.max.y) * 1e-6, 1e-300});
    const Point around(size.x > 0 ? size.x : some, size.y > 0 ? size.y : some);
    return {window.min - around, window.max + around};
}

CostPlan usualCostPlan(const Window& window)
{
    const Window area = areaAround(window);
    const Point from = area.min + (area.max - area.min) * Point(1. / 6, 0.4);
    return {.shown = Variant{clipping::findAlgorithm("MD")},
            .variants = costVariants(clipping::Form::Corrected),
            .measure = &costMeasures().front(),
            .fixed = from,
            .window = window,
            .area = area,
            .columns = 240,
            .rows = 180};
}

double costOf(const Variant& variant, const CostMeasure& measure, const Segment& line,
              const Window& window)
{
    if (measure.isTime())
        return nanosecondsOf(variant, line, window);
    return double(measure.of(functionsOf(variant).count({&line, 1}, window)));
}

Cheapest cheapestOf(const CostPlan& plan, const Segment& line)
{
    std::array<double, 32> costs{};
    assert(plan.variants.size() <= costs.size());
    Cheapest best{0, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < plan.variants.size(); ++i) {
        costs[i] = costOf(plan.variants[i], *plan.measure, line, plan.window);
        best.cost = std::min(best.cost, costs[i]);
    }
    const double most = plan.measure->isTime() ? best.cost * noise : best.cost;
    for (std::size_t i = 0; i < plan.variants.size(); ++i)
        if (costs[i] <= most)
            best.which |= 1u << i;
    return best;
}

CostMap extended(CostMap so, std::size_t cells)
{
    const CostPlan& plan = so.plan;
    const std::size_t first = so.values.size(), end = std::min(first + cells, plan.cells());
    so.values.reserve(plan.cells());
    for (std::size_t cell = first; cell < end; ++cell) {
        const auto columns = std::size_t(plan.columns);
        const Segment line = plan.lineTo(plan.middleOf(int(cell % columns), int(cell / columns)));
        if (plan.shown) {
            so.values.push_back(float(costOf(*plan.shown, *plan.measure, line, plan.window)));
            continue;
        }
        const Cheapest best = cheapestOf(plan, line);
        so.values.push_back(float(best.cost));
        so.cheapest.push_back(best.which);
    }
    return so;
}

CostMap costMap(CostPlan plan)
{
    const std::size_t all = plan.cells();
    return extended({std::move(plan)}, all);
}

} // namespace app
