// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cost_map/measure.h"

#include "app/base/numbers.h"
#include "app/base/promised_operations.h"
#include "app/base/text.h"

#include <array>

namespace app {

using clipping::OperationCounts;

std::span<const CostMeasure> costMeasures()
{
    static const std::array all{
        CostMeasure{"operations", Text::tr("Operations"), Text::tr("1 operation"),
                    Text::tr("%1 operations"), promisedOf},
        CostMeasure{"comparisons", Text::tr("Comparisons"), Text::tr("1 comparison"),
                    Text::tr("%1 comparisons"),
                    [](const OperationCounts& counts) { return counts.comparisons; }},
        CostMeasure{"additions", Text::tr("Additions and subtractions"), Text::tr("1 addition"),
                    Text::tr("%1 additions"),
                    [](const OperationCounts& counts) { return counts.additions; }},
        CostMeasure{"multiplications", Text::tr("Multiplications"), Text::tr("1 multiplication"),
                    Text::tr("%1 multiplications"),
                    [](const OperationCounts& counts) { return counts.multiplications; }},
        CostMeasure{"divisions", Text::tr("Divisions"), Text::tr("1 division"),
                    Text::tr("%1 divisions"),
                    [](const OperationCounts& counts) { return counts.divisions; }},
        CostMeasure{"time", Text::tr("Time (noisy)"), {}, Text::tr("%1 ns"), nullptr}};
    return all;
}

QString costText(const CostMeasure& measure, double cost)
{
    if (measure.isTime())
        return measure.many.arg(numberText(cost, cost < 100 ? 1 : 0));
    return cost == 1 ? measure.one : measure.many.arg(countText(std::size_t(cost)));
}

} // namespace app
