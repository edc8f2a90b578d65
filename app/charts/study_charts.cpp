// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/study_charts.h"

#include <algorithm>

namespace app {
namespace {

/// "table1-clip-published", "table1-clip-published-runs".
QString keyOf(const Trial& trial, const Measure& measure)
{
    if (!trial.paper)
        return measure.key;
    return QStringList{trial.paper->key, measure.key,
                       wordOf(trial.record.timings.front().variant.form)}
        .join(u'-');
}

} // namespace

std::vector<Chart> chartsOf(const Trial& trial, const Measure& measure)
{
    std::vector<Chart> charts{chartOf(trial.record, measure, trial.paper),
                              boxPlotOf(trial.record, measure)};
    charts[0].key = keyOf(trial, measure);
    charts[1].key = keyOf(trial, measure) + QStringLiteral("-runs");
    return charts;
}

std::vector<Chart> chartsOf(const Explanation& explanation)
{
    return {chartOf(explanation.classes), chartOf(explanation.operations)};
}

std::vector<Chart> chartsOf(const Study& study)
{
    std::vector<Chart> charts;
    const auto add = [&](std::vector<Chart> more) {
        std::ranges::move(more, std::back_inserter(charts));
    };
    QString last;
    for (const Trial& trial : study.trials) {
        if (trial.paper && trial.paper->key != last)
            charts.push_back(chartOf(*trial.paper));
        last = trial.paper ? trial.paper->key : QString();
        for (const Measure& measure : study.measures)
            add(chartsOf(trial, measure));
    }
    if (study.explanation)
        add(chartsOf(*study.explanation));
    return charts;
}

} // namespace app
