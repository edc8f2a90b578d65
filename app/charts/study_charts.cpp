// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/study_charts.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/charts/record_chart.h"
#include "app/charts/words.h"
#include "app/experiment/paper_tables.h"

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

namespace {

ChartRow paperRow(const PaperColumn& column, const Summary& runs, double lowest)
{
    const double average = column.printedAverage;
    ChartRow row = rowFor({column.algorithm, clipping::Form::Published});
    row.name = column.name;
    row.note.clear(); // all rows have the same note
    row.figures = {Bar{{average}, runs.confidence}};
    row.numbers = {numberText(average, 3), numberText(average / lowest, 2)};
    row.detail = QStringList{fullName({column.algorithm, clipping::Form::Corrected}),
                             Text::tr("average %1 s").arg(numberText(average, 3)),
                             Text::tr("median of its runs, with 95 % confidence: %1 to %2 s")
                                 .arg(numberText(runs.confidence.low, 3),
                                      numberText(runs.confidence.high, 3))}
                     .join(u'\n');
    return row;
}

} // namespace

Chart chartOf(const PaperTable& paper)
{
    std::vector<Summary> runs;
    for (const PaperColumn& column : paper.columns)
        runs.push_back(summaryOf(column.runs));
    const double lowest =
        std::ranges::min(paper.columns, {}, &PaperColumn::printedAverage).printedAverage;
    const Ranking ranking = rankingOf(paper);
    std::vector<std::size_t> order(paper.columns.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::ranges::stable_sort(order, {},
                             [&](std::size_t i) { return paper.columns[i].printedAverage; });
    Chart chart{
        .key = paper.key + QStringLiteral("-paper"),
        .title = Text::tr("The paper's %1").arg(numberOf(paper)),
        .subtitle = Text::tr("%1 lines generated, clipped and drawn").arg(countText(paper.lines)),
        .legend = {{LegendBar{0, clipping::Form::Published}, Text::tr("the paper's averages")}},
        .panels = {{{}, Text::tr("seconds")}},
        .columns = {Text::tr("seconds"), Text::tr("lowest = 1")},
        .rows = {},
        .groups = groupsOf(ranking, order),
        .notes = groupNotes(ranking) << paperPairingText()};
    for (const std::size_t i : order)
        chart.rows.push_back(paperRow(paper.columns[i], runs[i], lowest));
    return chart;
}

} // namespace app
