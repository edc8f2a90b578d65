// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/experiment/experiment.h"

#include <limits>

namespace app {
namespace {

constexpr quint64 mostLines = 4'000'000'000, mostRuns = 10'000;

Table tableOf(const std::vector<Timing>& timings, const ExperimentOptions& options)
{
    Table table{{"algorithm", "form", "median_ns", "spread_ns", "visible", "lines", "runs", "seed"},
                {}};
    for (const Timing& timing : timings) {
        const bool corrected = timing.contestant.form == clipping::Form::Corrected;
        table.rows.push_back({QLatin1StringView(timing.contestant.algorithm->key),
                              corrected ? QStringLiteral("corrected") : QStringLiteral("published"),
                              QString::number(timing.median(), 'f', 2),
                              QString::number(timing.spread(), 'f', 2),
                              QString::number(timing.visible), QString::number(options.lines),
                              QString::number(options.runs), QString::number(options.seed)});
    }
    return table;
}

void bench(const Given& given)
{
    ExperimentOptions options;
    options.lines = given.count(QStringLiteral("lines"), 1, mostLines).value_or(options.lines);
    options.runs = given.count(QStringLiteral("runs"), 1, mostRuns).value_or(options.runs);
    options.seed = given.count(QStringLiteral("seed"), 0, std::numeric_limits<quint64>::max())
                       .value_or(options.seed);
    auto algorithms = given.algorithms(QStringLiteral("algorithms"));
    if (algorithms.empty())
        for (const auto& algorithm : clipping::algorithms())
            algorithms.push_back(&algorithm);
    tableText({}, given); // a wrong --format is said before the work
    print(tableText(tableOf(experiment(options, contestants(algorithms)), options), given));
}

} // namespace

Command benchCommand()
{
    return {
        "bench",
        "[OPTIONS]",
        Commands::tr("Repeats the paper's experiment: random lines in (-960,-720)–(960,720) "
                     "clipped at (-100,-75)–(100,75). Says for each algorithm the median of the "
                     "nanoseconds a line over all runs, their spread between the quartiles, and "
                     "how many lines are visible."),
        {{{"n", "lines"}, "N", Commands::tr("Lines in a run (1000000).")},
         {{"r", "runs"}, "N", Commands::tr("Runs (10).")},
         {{"s", "seed"}, "N", Commands::tr("Which random lines (1).")},
         {{"a", "algorithms"},
          "LIST",
          Commands::tr("Keys or abbreviations with commas between them (all).")},
         tableOption()},
        {"clearcut bench --lines 10000000 --runs 10 --format csv > times.csv",
         "clearcut bench -a cs,lb,md"},
        0,
        bench};
}

} // namespace app
