// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_options.h"
#include "app/command_line/progress_line.h"
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/experiment/record.h"

#include <algorithm>

namespace app {
namespace {

Record measured(ExperimentOptions options, const std::vector<Contestant>& contestants,
                const std::vector<Measure>& wanted)
{
    if (std::ranges::any_of(wanted, &Measure::draws))
        options.easel = rasterEasel;
    ProgressLine line;
    return *recorded(options, contestants,
                     {{}, [&](const Progress& progress) { line.show(progress); }});
}

void bench(const Given& given)
{
    const auto format = tableFormat(given);
    const auto wanted = measuresGiven(given, QStringLiteral("clip"));
    const auto contestants = contestantsGiven(given);
    if (contestants.empty())
        throw WrongUsage{Commands::tr("None of these algorithms has a published form.")};
    const Record record = measured(experimentGiven(given), contestants, wanted);
    std::vector<Table> tables;
    for (const Measure& measure : wanted)
        tables.push_back(timesTable(record, measure));
    print(format.text(tables));
}

} // namespace

Command benchCommand()
{
    auto options = experimentOptions();
    options.push_back(tableOption());
    return {
        "bench",
        "[OPTIONS]",
        Commands::tr("Repeats the paper's experiment: random lines in (-960,-720)–(960,720) "
                     "clipped at (-100,-75)–(100,75), or other scenes. Says for each algorithm "
                     "the nanoseconds a line (median, spread between the quartiles, mean and its "
                     "confidence interval over all runs), its rank where there is one, and how "
                     "many lines are visible and how many it loses."),
        options,
        {"clearcut bench --lines 10000000 --runs 10 --format csv > times.csv",
         "clearcut bench -a cs,lb,md --measure clip,draw,total",
         "clearcut bench --quick --scene near-miss --order sorted"},
        0,
        bench};
}

} // namespace app
