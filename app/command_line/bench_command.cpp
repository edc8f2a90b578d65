// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_options.h"
#include "app/command_line/progress_line.h"
#include "app/command_line/refusal.h"
#include "app/command_line/table.h"
#include "app/experiment/study.h"

#include <algorithm>

namespace app {
namespace {

Study measured(const Plan& plan)
{
    ProgressLine line;
    return *study(plan, {{}, [&](const Progress& progress) { line.show(progress); }});
}

std::vector<Table> tablesOf(const Study& study, Against against)
{
    std::vector<Table> tables;
    for (const Trial& trial : study.trials)
        for (const Measure& measure : study.measures)
            std::ranges::move(tablesOf(trial, measure, against), std::back_inserter(tables));
    return tables;
}

std::vector<Table> sceneTables(const Given& given)
{
    const Wanted wanted = wantedGiven(given, QStringLiteral("clip"));
    const auto contestants = contestantsGiven(given);
    if (contestants.empty())
        throw WrongUsage{Commands::tr("None of these algorithms has a published form.")};
    const ExperimentOptions options = experimentGiven(given, wanted);
    std::vector<Table> tables;
    if (!wanted.measures.empty())
        tables = tablesOf(measured({{{std::nullopt, options, contestants}}, wanted.measures}),
                          Against::Nothing);
    for (const Analysis& analysis : wanted.analyses) {
        ProgressLine line;
        tables.push_back(*analysis.table(
            options, contestants, {{}, [&](const Progress& progress) { line.show(progress); }}));
    }
    return tables;
}

/// The tables of the paper that --paper names.
std::vector<PaperTable> papersGiven(const Given& given)
{
    if (given.has(QStringLiteral("algorithms")))
        throw WrongUsage{Commands::tr("--paper has algorithms of its own: leave -a away.")};
    auto tables = paperTables();
    QStringList words;
    for (const PaperTable& table : tables)
        words << table.key;
    const auto choice = given.choice(QStringLiteral("paper"), words + QStringList("all"));
    if (choice < tables.size())
        return {tables[choice]};
    return tables;
}

std::vector<clipping::Form> paperForms(const Given& given)
{
    const auto forms = formsGiven(given);
    return given.has(QStringLiteral("form")) ? forms : std::vector{clipping::Form::Published};
}

std::vector<Table> paperTables(const Given& given)
{
    const Wanted wanted = wantedGiven(given, QStringLiteral("clip,draw,total"));
    if (!wanted.analyses.empty())
        throw WrongUsage{Commands::tr("--paper measures clip, draw and total: leave “%1” away.")
                             .arg(wanted.analyses[0].key)};
    const bool against = given.has(QStringLiteral("against-paper"));
    const bool ownLines = given.has(QStringLiteral("lines")) || given.has(QStringLiteral("quick"));
    const ExperimentOptions options = experimentGiven(given, wanted);
    std::vector<Table> tables;
    for (const PaperTable& paper : papersGiven(given)) {
        if (against)
            tables.push_back(paperLayout(paper));
        Plan plan{{}, wanted.measures};
        for (const clipping::Form form : paperForms(given)) {
            plan.trials.push_back({paper, options, contestants(paper, form)});
            if (!ownLines)
                plan.trials.back().options.lines = paper.lines;
        }
        std::ranges::move(tablesOf(measured(plan), against ? Against::Paper : Against::Nothing),
                          std::back_inserter(tables));
    }
    return tables;
}

void bench(const Given& given)
{
    const auto output = tableOutput(given);
    const bool paper = given.has(QStringLiteral("paper"));
    if (given.has(QStringLiteral("against-paper")) && !paper)
        throw WrongUsage{Commands::tr("--against-paper needs --paper table1, table2 or all.")};
    writeTables(output, paper ? paperTables(given) : sceneTables(given));
}

std::vector<Option> benchOptions()
{
    std::vector<Option> options{
        {{"paper"},
         "table1|table2|all",
         Commands::tr("Tables 1 and 2 in the paper's layout: its seven algorithms as published, "
                      "1000000 and 10000000 lines, 10 runs; clip, draw and total apart.")},
        {{"against-paper"}, {}, Commands::tr("With --paper: the paper's own numbers beside ours.")},
    };
    for (Option& option : experimentOptions())
        options.push_back(std::move(option));
    for (Option& option : tableOptions())
        options.push_back(std::move(option));
    return options;
}

} // namespace

Command benchCommand()
{
    return {
        "bench",
        "[OPTIONS]",
        Commands::tr("Repeats the paper's experiment: random lines in (-960,-720)–(960,720) "
                     "clipped at (-100,-75)–(100,75), or other scenes. Says for each algorithm "
                     "the nanoseconds a line (median, spread between the quartiles, mean and its "
                     "confidence interval over all runs), its rank where there is one, and how "
                     "many lines are visible and how many it loses."),
        benchOptions(),
        {"clearcut bench --paper all --against-paper",
         "clearcut bench --lines 10000000 --runs 10 --format csv > times.csv",
         "clearcut bench -a cs,lb,md --measure clip,draw,total",
         "clearcut bench --quick --scene near-miss --order sorted",
         "clearcut bench --measure classes,operations,accuracy"},
        0,
        bench,
        true};
}

} // namespace app
