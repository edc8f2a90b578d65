// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/record_chart.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/charts/words.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/paper_tables.h"
#include "app/experiment/ranking_text.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

const PaperColumn* columnOf(const PaperTable& paper, const clipping::Algorithm* algorithm)
{
    const auto found = std::ranges::find(paper.columns, algorithm, &PaperColumn::algorithm);
    return found == paper.columns.end() ? nullptr : &*found;
}

double lowestOf(const PaperTable& paper)
{
    return std::ranges::min(paper.columns, {}, &PaperColumn::printedAverage).printedAverage;
}

/// Whether the paper's time of this algorithm is shown beside this timing.
bool comparable(const Record& record, const Timing& timing, const PaperTable& paper)
{
    return columnOf(paper, timing.variant.algorithm)
           && std::ranges::none_of(record.timings, [&](const Timing& other) {
                  return other.variant.algorithm == timing.variant.algorithm
                         && other.variant.form < timing.variant.form;
              });
}

/// Which of the sorted timings has the value 1: the lowest median. Beside a table of the paper,
/// only the paper's algorithms count, otherwise the two scales could not be compared.
std::size_t unitTiming(const Record& record, std::span<const std::size_t> order,
                       const std::optional<PaperTable>& paper)
{
    if (!paper)
        return order.front();
    const auto found = std::ranges::find_if(
        order, [&](std::size_t i) { return comparable(record, record.timings[i], *paper); });
    return found == order.end() ? order.front() : *found;
}

QString detailOf(const Variant& variant, const Summary& times)
{
    QStringList lines{fullName(variant),
                      Text::tr("median %1 per line").arg(nanosecondsText(times.median))};
    if (std::isfinite(times.confidence.low) && std::isfinite(times.confidence.high))
        lines << Text::tr("with 95 % confidence: %1 to %2")
                     .arg(nanosecondsText(times.confidence.low),
                          nanosecondsText(times.confidence.high));
    lines << Text::tr("spread %1, mean %2")
                 .arg(nanosecondsText(times.spread), nanosecondsText(times.mean));
    return lines.join(u'\n');
}

/// Relative to the lowest median; empty if there are too few runs for a confidence interval.
std::optional<Interval> relative(const Interval& confidence, double lowest)
{
    if (!std::isfinite(confidence.low) || !std::isfinite(confidence.high))
        return std::nullopt;
    return Interval{confidence.low / lowest, confidence.high / lowest};
}

QString ratioText(double ratio) { return numberText(ratio, 2); }

/// The test of a thing against the lowest median; empty for that thing itself.
QString testText(const Ranking& ranking, std::size_t thing)
{
    if (thing == ranking.order.front() || !ranking.told)
        return {};
    const PairTest& test = ranking.againstLowest(thing);
    return u'\n'
           + Text::tr("%1 times the lowest median, p = %2")
                 .arg(numberText(test.ratio, 3), pText(test.p));
}

/// `ratio`: to the lowest, as in tables and sentences: the median over the runs.
ChartRow recordRow(const Variant& variant, const Summary& times, double lowest, double ratio)
{
    ChartRow row = rowFor(variant);
    row.value = nanosecondsText(times.median);
    row.figures = {Bar{{times.median / lowest}, relative(times.confidence, lowest)}};
    row.numbers = {ratioText(ratio)};
    row.detail = detailOf(variant, times);
    return row;
}

void compare(ChartRow& row, const PaperTable& paper)
{
    const PaperColumn* column = columnOf(paper, row.variant.algorithm);
    row.other = column->printedAverage / lowestOf(paper);
    row.numbers << ratioText(*row.other);
    row.detail += u'\n'
                  + Text::tr("in the paper: %1 s, %2 times the paper's lowest")
                        .arg(numberText(column->printedAverage, 3), ratioText(*row.other));
}

/// Deviations in per cent of the median; empty if the median is 0.
std::vector<double> deviations(std::vector<double> runs, double median)
{
    for (double& run : runs)
        run = median > 0 ? 100 * (run / median - 1) : 0;
    return runs;
}

std::vector<LegendEntry> legendOf(const Record& record)
{
    const auto has = [&](clipping::Form form) {
        return std::ranges::any_of(
            record.timings, [&](const Timing& timing) { return timing.variant.form == form; });
    };
    const QString here = Text::tr("here, median of %1").arg(countText(record.options.runs));
    std::vector<LegendEntry> legend;
    if (has(clipping::Form::Corrected))
        legend.push_back({LegendBar{}, here});
    if (has(clipping::Form::Published))
        legend.push_back({LegendBar{0, clipping::Form::Published},
                          legend.empty() ? here : Text::tr("as published")});
    return legend;
}

void addBatches(Chart& chart, const Record& record)
{
    if (const QString batches = batchText(variantsOf(record)); !batches.isEmpty())
        chart.notes << batches;
}

} // namespace

Chart chartOf(const Record& record, const Measure& measure, const std::optional<PaperTable>& paper)
{
    const auto times = summaries(record, measure);
    const auto order = sortedByMedian(times);
    const std::size_t one = unitTiming(record, order, paper);
    const Ranking ranking = rankingOf(record, measure);
    Chart chart{.key = QStringLiteral("%1-%2").arg(record.options.scene.key, measure.key),
                .title = (one == order.front()
                              ? Text::tr("%1, lowest median = 1")
                              : Text::tr("%1, lowest median of the paper's algorithms = 1"))
                             .arg(measure.name),
                .subtitle = sceneText(record.options),
                .legend = legendOf(record),
                .columns = {Text::tr("here")},
                .rows = {},
                .groups = groupsOf(ranking, order),
                .reference = 1,
                .notes = groupNotes(ranking)};
    for (const std::size_t i : order) {
        chart.rows.push_back(recordRow(record.timings[i].variant, times[i], times[one].median,
                                       ranking.pairs[i][one].ratio));
        chart.rows.back().detail += testText(ranking, i);
        if (paper && comparable(record, record.timings[i], *paper))
            compare(chart.rows.back(), *paper);
    }
    if (paper) {
        chart.key = QStringLiteral("%1-%2").arg(paper->key, measure.key);
        chart.columns << Text::tr("paper");
        chart.legend.push_back(
            {LegendMark{}, Text::tr("hollow: the paper's %1, total time of %2 lines")
                               .arg(numberOf(*paper), countText(paper->lines))});
        if (const QString other = otherWorkText(*paper, record.options, measure); !other.isEmpty())
            chart.notes << other;
    }
    addBatches(chart, record);
    return withSharedNote(std::move(chart));
}

Chart boxPlotOf(const Record& record, const Measure& measure)
{
    const auto times = summaries(record, measure);
    const auto order = sortedByMedian(times);
    const Ranking ranking = rankingOf(record, measure);
    Chart chart{.key = QStringLiteral("%1-%2-runs").arg(record.options.scene.key, measure.key),
                .title = Text::tr("%1, run by run").arg(measure.name),
                .subtitle = sceneText(record.options),
                .legend = {{LegendBox{}, Text::tr("quartiles and median of %1 runs; circles: "
                                                  "outliers")
                                             .arg(countText(record.options.runs))}},
                .panels = {{{}, Text::tr("nanoseconds per line"), false},
                           {{}, Text::tr("deviation from its median in %"), false}},
                .oneScale = false,
                .columns = {Text::tr("median")},
                .rows = {},
                .groups = groupsOf(ranking, order),
                .notes = groupNotes(ranking)};
    for (const std::size_t i : order) {
        const auto runs = measure.times(record.timings[i]);
        ChartRow row = rowFor(record.timings[i].variant);
        row.figures = {boxOf(runs), boxOf(deviations(runs, times[i].median))};
        row.numbers = {nanosecondsText(times[i].median)};
        row.detail = detailOf(record.timings[i].variant, times[i]);
        chart.rows.push_back(std::move(row));
    }
    addBatches(chart, record);
    return withSharedNote(std::move(chart));
}

} // namespace app
