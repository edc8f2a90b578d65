// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/measure.h"

#include "app/base/latin.h"
#include "app/base/numbers.h"
#include "app/base/promised_operations.h"
#include "app/cost_map/words.h"

#include <algorithm>
#include <array>

namespace app {

using clipping::OperationCounts;

std::span<const CostMeasure> costMeasures()
{
    using C = CostMaps;
    static const std::array all{
        CostMeasure{"operations", C::tr("Operations"), C::tr("1 operation"), C::tr("%1 operations"),
                    promisedOf},
        CostMeasure{"comparisons", C::tr("Comparisons"), C::tr("1 comparison"),
                    C::tr("%1 comparisons"),
                    [](const OperationCounts& counts) { return counts.comparisons; }},
        CostMeasure{"additions", C::tr("Additions and subtractions"), C::tr("1 addition"),
                    C::tr("%1 additions"),
                    [](const OperationCounts& counts) { return counts.additions; }},
        CostMeasure{"multiplications", C::tr("Multiplications"), C::tr("1 multiplication"),
                    C::tr("%1 multiplications"),
                    [](const OperationCounts& counts) { return counts.multiplications; }},
        CostMeasure{"divisions", C::tr("Divisions"), C::tr("1 division"), C::tr("%1 divisions"),
                    [](const OperationCounts& counts) { return counts.divisions; }},
        CostMeasure{"time", C::tr("Time (noisy)"), {}, C::tr("%1 ns"), nullptr}};
    return all;
}

const CostMeasure* findCostMeasure(const QString& key)
{
    const auto found = std::ranges::find_if(
        costMeasures(), [&](const CostMeasure& measure) { return latin(measure.key) == key; });
    return found == costMeasures().end() ? nullptr : &*found;
}

QString costText(const CostMeasure& measure, double cost)
{
    if (measure.isTime())
        return measure.many.arg(numberText(cost, cost < 100 ? 1 : 0));
    return cost == 1 ? measure.one : measure.many.arg(countText(std::size_t(cost)));
}

} // namespace app
