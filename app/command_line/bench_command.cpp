// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/command_line/bench_files.h"
#include "app/command_line/bench_plan.h"
#include "app/command_line/command.h"
#include "app/command_line/table.h"
#include "app/command_line/terminal.h"
#include "app/experiment/choice.h"
#include "app/experiment/threads.h"
#include "app/report/process_runs.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

constexpr auto eachRun = "each-run", verbose = "verbose", processes = "processes",
               oneRun = "one-run";

/// The measures without --measure: all of them for a report that people read.
QString usualMeasures(const ParsedArguments& arguments, bool forPeople)
{
    QStringList keys{QStringLiteral("clip")};
    if (forPeople || arguments.has(QStringLiteral("paper")))
        keys << QStringLiteral("draw") << QStringLiteral("total");
    if (forPeople && parsedPrecision(arguments) == Precision::Double)
        for (const Analysis& analysis : analyses())
            keys << analysis.key;
    return keys.join(u',');
}

Study measured(const Plan& plan)
{
    ProgressLine line;
    if (plan.trials.empty() || !plan.trials.front().options.inProcesses)
        return *study(plan, line.follower());
    const RunProgram same{QCoreApplication::applicationFilePath(),
                          QCoreApplication::arguments().sliced(1)};
    auto records = recordsInProcesses(plan, same, line.follower());
    if (!records)
        throw Failure{records.error};
    return *study(plan, std::move(*records.value));
}

Table analysed(const Analysis& analysis, const PlannedTrial& trial)
{
    ProgressLine line;
    return *analysis.table(trial.options, trial.variants, line.follower());
}

/// In the order of trials; the paper's own numbers come before the first trial that repeats them.
std::vector<Table> tablesOf(const Study& study, Against against)
{
    std::vector<Table> tables;
    QString last;
    for (const Trial& trial : study.trials) {
        if (against == Against::Paper && trial.paper->key != last) {
            tables.push_back(paperLayout(*trial.paper));
            last = trial.paper->key;
        }
        for (const Measure& measure : study.measures)
            std::ranges::move(tablesOf(trial, measure, against), std::back_inserter(tables));
    }
    return tables;
}

std::vector<Table> runsTables(const Study& study)
{
    std::vector<Table> tables;
    for (const Trial& trial : study.trials)
        tables.push_back(runsTable(trial.record, study.measures));
    return tables;
}

/// briefTimesTable() of each trial on a scene; the paper's layouts have no shorter form.
std::vector<Table> briefTables(const Study& study, Against against)
{
    std::vector<Table> tables;
    for (const Trial& trial : study.trials)
        for (const Measure& measure : study.measures)
            if (!trial.paper)
                tables.push_back(briefTimesTable(trial.record, measure));
    if (tables.empty())
        return tablesOf(study, against);
    tables.back().notes << Text::tr("More columns and how this was measured: -v. Data: -f csv.");
    return tables;
}

/// Whether people read the tables, and did not ask for all columns.
bool isBrief(const ParsedArguments& arguments, const TableOutput& output)
{
    return output.format.key == tableFormats().front().key
           && !arguments.has(QLatin1StringView(verbose));
}

std::vector<Table> tablesOf(const ParsedArguments& arguments, const TableOutput& output,
                            const Study& study)
{
    const Against against = parsedAgainst(arguments);
    auto tables = arguments.has(QLatin1StringView(eachRun)) ? runsTables(study)
                  : isBrief(arguments, output)              ? briefTables(study, against)
                                                            : tablesOf(study, against);
    if (study.explanation)
        std::ranges::move(tablesOf(*study.explanation), std::back_inserter(tables));
    return tables;
}

void bench(const ParsedArguments& arguments)
{
    const auto output = tableOutput(arguments);
    const auto files = parsedFiles(arguments);
    parsedAgainst(arguments); // throws before the work
    Wanted wanted = parsedWanted(arguments, usualMeasures(arguments, !files.empty()));
    if (wanted.measures.empty() && !files.empty())
        throw WrongUsage{Text::tr("Reports and charts need clip, draw or total in --measure.")};
    Plan plan = parsedPlan(arguments, wanted);
    if (plan.trials.front().options.field.shape)
        wanted.analyses.clear(); // they explain rectangles only
    plan.explained = explanationOf(plan);
    if (!arguments.has(QStringLiteral("runs")))
        takeUsualRuns(plan);
    if (const auto run = arguments.count(QLatin1StringView(oneRun), 0, mostRuns - 1))
        return print(QString::fromUtf8(dataOfRun(*study(planOfRun(plan, *run)))));
    for (PlannedTrial& trial : plan.trials)
        trial.options.inProcesses = arguments.has(QLatin1StringView(processes));
    const PlannedTrial explained = *plan.explained;
    if (wanted.measures.empty())
        plan.trials.clear();
    if (files.empty() || wanted.analyses.empty())
        plan.explained.reset();
    const Study study = measured(plan);
    auto tables = tablesOf(arguments, output, study);
    if (!study.explanation)
        for (const Analysis& analysis : wanted.analyses)
            tables.push_back(analysed(analysis, explained));
    writeTables(output, tables);
    writeFiles(files, study);
}

std::vector<Option> benchOptions()
{
    std::vector<Option> all = paperOptions();
    const auto add = [&](std::vector<Option> more) {
        std::ranges::move(more, std::back_inserter(all));
    };
    add(experimentOptions());
    add({{{processes},
          {},
          Text::tr("Make each run in a process of its own, so that the confidence intervals cover "
                   "more than the noise of the clock; takes about twice as long.")},
         {{oneRun}, "N", Text::tr("Print the data of this run alone, which --processes asks for.")},
         {{eachRun}, {}, Text::tr("One row for each run instead of a summary.")},
         {{"v", verbose},
          {},
          Text::tr("All columns and how it was measured, also in the text format.")}});
    add(tableOptions());
    add(fileOptions());
    return all;
}

} // namespace

Command benchCommand()
{
    return {
        "bench",
        "[OPTIONS]",
        Text::tr("Repeats the paper's experiment: random lines in (-960,-720)–(960,720) clipped at "
                 "(-100,-75)–(100,75), or other scenes. Prints for each algorithm the nanoseconds "
                 "per line (the median), the ratio to the lowest, and the number of lines that it "
                 "loses. One that differs significantly from every other, by 1 % or more, has a "
                 "rank. With -v it also prints letters (algorithms that share none differ), "
                 "spread between the quartiles, mean, and the 95 % confidence interval of the "
                 "median. Exact clips many lines at once with vector "
                 "instructions; exact-one-by-one is called line by line, like the others."),
        benchOptions(),
        {"clearcut bench --paper all --against-paper",
         "clearcut bench --paper all --report paper.html",
         "clearcut bench --lines 10000000 --each-run --format csv > times.csv",
         "clearcut bench -a cs,lb,md --measure clip,draw,total",
         "clearcut bench --quick --scene near-miss --order sorted",
         "clearcut bench --measure classes,operations,accuracy"},
        0,
        bench,
        Paints::Pictures,
        {Text::tr("At most %1 lines and %2 runs; threads: at most %3 here.")
             .arg(countText(mostLines), countText(mostRuns), countText(mostThreads()))}};
}

} // namespace app
