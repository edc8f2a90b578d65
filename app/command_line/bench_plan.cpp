// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_plan.h"

#include "app/command_line/refusal.h"

#include <algorithm>

namespace app {
namespace {

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

std::vector<PlannedTrial> paperTrials(const Given& given, const ExperimentOptions& options)
{
    const bool ownLines = given.has(QStringLiteral("lines")) || given.has(QStringLiteral("quick"));
    return app::paperTrials(papersGiven(given), paperForms(given), options,
                            ownLines ? std::optional(options.lines) : std::nullopt);
}

PlannedTrial sceneTrial(const Given& given, const ExperimentOptions& options)
{
    auto variants = variantsGiven(given);
    if (variants.empty())
        throw WrongUsage{Commands::tr("None of these algorithms has a published form.")};
    return {std::nullopt, options, std::move(variants)};
}

bool repeatsPaper(const Given& given) { return given.has(QStringLiteral("paper")); }

} // namespace

std::vector<Option> paperOptions()
{
    return {
        {{"paper"},
         "table1|table2|all",
         Commands::tr("Tables 1 and 2 in the paper's layout: its seven algorithms as published, "
                      "1000000 and 10000000 lines, 10 runs; clip, draw and total apart.")},
        {{"against-paper"}, {}, Commands::tr("With --paper: the paper's own numbers beside ours.")},
    };
}

Plan planGiven(const Given& given, const Wanted& wanted)
{
    const ExperimentOptions options = experimentGiven(given, wanted);
    if (repeatsPaper(given))
        return {paperTrials(given, options), wanted.measures};
    return {{sceneTrial(given, options)}, wanted.measures};
}

Against againstGiven(const Given& given)
{
    if (!given.has(QStringLiteral("against-paper")))
        return Against::Nothing;
    if (!repeatsPaper(given))
        throw WrongUsage{Commands::tr("--against-paper needs --paper table1, table2 or all.")};
    return Against::Paper;
}

PlannedTrial explanationOf(const Plan& plan)
{
    PlannedTrial all{std::nullopt, plan.trials.front().options, {}};
    for (const PlannedTrial& trial : plan.trials)
        for (const Variant& one : trial.variants)
            if (std::ranges::find(all.variants, one) == all.variants.end())
                all.variants.push_back(one);
    return all;
}

} // namespace app
