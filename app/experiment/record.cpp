// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/record.h"

#include "app/base/short_names.h"
#include "app/base/text.h"
#include "app/experiment/circumstances.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/ranking_text.h"
#include "app/formats/coordinates.h"

#include <algorithm>

namespace app {
namespace {

QString inNanoseconds(double time) { return QString::number(time, 'f', 2); }

QString hexadecimal(std::uint64_t checksum)
{
    return QStringLiteral("%1").arg(checksum, 16, 16, QLatin1Char('0'));
}

/// "OpenGL 4.5, llvmpipe; wall clock"
QString drawTargetText(const ExperimentOptions& options, const DrawTarget& target)
{
    const Clock clock = drawClock(options, target);
    return clock.name == options.clock.name
               ? target.name()
               : target.name() + QStringLiteral("; clock: ") + clock.name;
}

QStringList timingRow(const Timing& timing, const Summary& times, const Ranking& ranking,
                      std::size_t thing)
{
    return {QString::fromUtf8(timing.variant.algorithm->key),
            wordOf(timing.variant.form),
            rankText(ranking, thing),
            lettersText(ranking, thing),
            inNanoseconds(times.median),
            ratioToFastestText(ranking, thing),
            pToFastestText(ranking, thing),
            inNanoseconds(times.spread),
            inNanoseconds(times.mean),
            boundText(times.confidence.low),
            boundText(times.confidence.high),
            QString::number(timing.found.visible),
            QString::number(timing.found.lost),
            QString::number(timing.found.shown),
            hexadecimal(timing.found.checksum)};
}

/// Which lines the runs had, and what that means; empty if all had the same.
QString seedsText(const ExperimentOptions& options)
{
    if (options.scene.lines > 0 || options.runs < 2)
        return {};
    return Text::tr("Each run has lines of its own, of the seeds %1 to %2, so that spread and "
                    "confidence intervals cover other lines, too. Visible, lost, shown and "
                    "checksum are of the first seed.")
               .arg(options.seed)
               .arg(options.seed + options.runs - 1)
           + (options.inProcesses ? Text::tr(" Each run was a process of its own.") : QString());
}

/// The median clipping time of an algorithm; empty if it was not timed.
std::optional<double> medianOf(const Record& record, const clipping::Algorithm& algorithm)
{
    const auto found = std::ranges::find_if(record.timings, [&](const Timing& timing) {
        return timing.variant.algorithm == &algorithm;
    });
    return found == record.timings.end() ? std::nullopt
                                         : std::optional(summaryOf(found->clip).median);
}

} // namespace

std::optional<Record> recorded(const ExperimentOptions& options, std::span<const Variant> variants,
                               const Follower& follower)
{
    ExperimentOptions asked = options;
    QString drew; // the draw target used, which may not be the requested one
    if (options.target)
        asked.target = [&](const Field& field) {
            auto target = options.target(field);
            drew = drawTargetText(options, *target);
            return target;
        };
    auto timings = experiment(asked, variants, follower);
    if (!timings)
        return std::nullopt;
    asked.target = nullptr; // a record does not draw any more
    return Record{std::move(asked), drew, circumstances(), std::move(*timings)};
}

std::vector<Summary> summaries(const Record& record, const Measure& measure)
{
    std::vector<Summary> all;
    for (const Timing& timing : record.timings)
        all.push_back(summaryOf(measure.times(timing)));
    return all;
}

std::vector<Variant> variantsOf(const Record& record)
{
    std::vector<Variant> all;
    for (const Timing& timing : record.timings)
        all.push_back(timing.variant);
    return all;
}

std::vector<std::vector<double>> runsOf(const Record& record, const Measure& measure)
{
    std::vector<std::vector<double>> all;
    for (const Timing& timing : record.timings)
        all.push_back(measure.times(timing));
    return all;
}

Ranking rankingOf(const Record& record, const Measure& measure)
{
    return rankingOf(runsOf(record, measure));
}

std::vector<std::pair<QString, QString>> factsOf(const ExperimentOptions& options)
{
    return {
        {"scene", options.scene.key},
        {"lines", QString::number(options.lines)},
        {"seed", QString::number(options.seed)},
        {"space", rectangleText(options.field.space)},
        {"window", windowText(options.field)},
    };
}

std::vector<std::pair<QString, QString>> factsOf(const Record& record)
{
    const ExperimentOptions& options = record.options;
    auto facts = factsOf(options);
    facts.emplace_back("order", latin(nameOf(options.order).words));
    facts.emplace_back("precision", wordOf(options.precision));
    facts.emplace_back("threads", QString::number(options.threads));
    facts.emplace_back("runs", QString::number(options.runs));
    facts.emplace_back("processes", options.inProcesses ? "one for each run" : "one");
    facts.emplace_back("warmup", QString::number(options.warmUps));
    facts.emplace_back("clock", options.clock.name);
    if (!record.target.isEmpty())
        facts.emplace_back("drawn", record.target);
    facts.insert(facts.end(), record.circumstances.begin(), record.circumstances.end());
    return facts;
}

QString batchText(const Record& record)
{
    const auto batch = medianOf(record, clipping::exactAlgorithm());
    const auto each = medianOf(record, exactOneByOne());
    if (!batch || !each)
        return {};
    return Text::tr("Exact (EX) is timed in batches: it clips many lines at once with the "
                    "processor's vector instructions and takes %1. Called line by line, "
                    "like the other algorithms, it takes %2.")
        .arg(timeText(*batch), timeText(*each));
}

Table timesTable(const Record& record, const Measure& measure)
{
    Table table{.names = {"algorithm", "form", "rank", "letters", "median_ns", "ratio_fastest",
                          "p_fastest", "spread_ns", "mean_ns", "low_ns", "high_ns", "visible",
                          "lost", "shown", "checksum"},
                .title = Text::tr("%1: nanoseconds per line").arg(measure.name),
                .key = measure.key,
                .facts = factsOf(record),
                .notes = {measure.meaning}};
    const auto times = summaries(record, measure);
    const Ranking ranking = rankingOf(record, measure);
    for (std::size_t i = 0; i < times.size(); ++i)
        table.rows.push_back(timingRow(record.timings[i], times[i], ranking, i));
    table.notes << Text::tr(
        "Low to high: the 95 % confidence interval of the median. Lost: visible lines that the "
        "algorithm drops. Shown: invisible lines that it keeps.");
    if (const QString seeds = seedsText(record.options); !seeds.isEmpty())
        table.notes << seeds;
    if (record.options.precision == Precision::Single)
        table.notes << Text::tr("In single precision the ends differ by some ulps, so "
                                "algorithms that agree may still have different checksums.");
    if (const QString batches = batchText(variantsOf(record)); !batches.isEmpty())
        table.notes << batches;
    table.notes << rankingNotes(ranking) << ratioNotes(ranking);
    return table;
}

Table briefTimesTable(const Record& record, const Measure& measure)
{
    const Table whole = timesTable(record, measure);
    Table table{.names = {"algorithm", "form", "rank", "median_ns", "ratio_fastest", "lost"},
                .title = whole.title,
                .key = whole.key};
    for (const std::size_t i : rankingOf(record, measure).order) {
        table.rows.emplace_back();
        for (const QString& name : table.names)
            table.rows.back() << whole.rows[i][whole.names.indexOf(name)];
    }
    for (const auto& fact : whole.facts)
        if (QStringList{"lines", "runs", "drawn", "processor", "compiler"}.contains(fact.first))
            table.facts.push_back(fact);
    table.notes << Text::tr("Ratio: to the lowest median. No rank: the algorithm does not differ "
                            "significantly from every other one. Lost: visible lines that it "
                            "drops.");
    if (const QString batches = batchText(variantsOf(record)); !batches.isEmpty())
        table.notes << batches;
    return table;
}

Table runsTable(const Record& record, std::span<const Measure> measures)
{
    Table table{.names = {"algorithm", "form", "measure", "run", "lines", "visible", "seconds"},
                .title = Text::tr("Every run"),
                .key = QStringLiteral("runs"),
                .facts = factsOf(record)};
    std::erase_if(table.facts, [](const auto& fact) { return fact.first == u"lines"; });
    for (const Measure& measure : measures)
        for (const Timing& timing : record.timings) {
            const auto times = measure.times(timing);
            for (std::size_t run = 0; run < times.size(); ++run)
                table.rows.push_back(
                    {QString::fromUtf8(timing.variant.algorithm->key), wordOf(timing.variant.form),
                     measure.key, QString::number(run + 1), QString::number(record.options.lines),
                     QString::number(run < timing.visible.size() ? timing.visible[run]
                                                                 : timing.found.visible),
                     QString::number(times[run] * double(record.options.lines) * 1e-9, 'f', 9)});
        }
    return table;
}

} // namespace app
