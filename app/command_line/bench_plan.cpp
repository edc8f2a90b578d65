// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_plan.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"

#include <algorithm>

namespace app {
namespace {

/// The tables of the paper that --paper names.
std::vector<PaperTable> parsedPapers(const ParsedArguments& arguments)
{
    if (arguments.has(QStringLiteral("algorithms")))
        throw WrongUsage{Text::tr("--paper chooses the algorithms itself: leave out -a.")};
    auto tables = paperTables();
    QStringList words;
    for (const PaperTable& table : tables)
        words << table.key;
    const auto choice = arguments.choice(QStringLiteral("paper"), words + QStringList("all"));
    if (choice < tables.size())
        return {tables[choice]};
    return tables;
}

std::vector<clipping::Form> paperForms(const ParsedArguments& arguments)
{
    const auto forms = parsedForms(arguments);
    return arguments.has(QStringLiteral("form")) ? forms : std::vector{clipping::Form::Published};
}

std::vector<PlannedTrial> paperTrials(const ParsedArguments& arguments,
                                      const ExperimentOptions& options)
{
    const bool ownLines =
        arguments.has(QStringLiteral("lines")) || arguments.has(QStringLiteral("quick"));
    return app::paperTrials(parsedPapers(arguments), paperForms(arguments), options,
                            ownLines ? std::optional(options.lines) : std::nullopt);
}

/// The variants that can clip at a window; reports those that cannot.
std::vector<Variant> ableVariants(const ShapedWindow& window, std::vector<Variant> variants)
{
    const QString unable = unableText(window, variants);
    variants = withoutUnable(window, std::move(variants));
    if (variants.empty())
        throw WrongUsage{unable + QStringLiteral(" ")
                         + Text::tr("Nothing is left to time: give others with -a.")};
    if (!unable.isEmpty())
        say(unable);
    return variants;
}

PlannedTrial sceneTrial(const ParsedArguments& arguments, const ExperimentOptions& options)
{
    auto variants = parsedVariants(arguments);
    if (variants.empty())
        throw WrongUsage{Text::tr("None of these algorithms has a published form.")};
    if (const auto& shape = options.field.shape)
        variants = ableVariants(*shape, std::move(variants));
    return {std::nullopt, options, std::move(variants)};
}

bool repeatsPaper(const ParsedArguments& arguments)
{
    return arguments.has(QStringLiteral("paper"));
}

} // namespace

std::vector<Option> paperOptions()
{
    return {
        {{"paper"},
         "table1|table2|all",
         Text::tr(
             "Tables 1 and 2 in the paper's layout: its seven algorithms as published, 1000000 and "
             "10000000 lines, 10 runs. Clip, draw and total are measured separately.")},
        {{"against-paper"},
         {},
         Text::tr("With --paper: show the paper's own numbers beside ours.")},
    };
}

Plan parsedPlan(const ParsedArguments& arguments, const Wanted& wanted)
{
    const ExperimentOptions options = parsedExperiment(arguments, wanted);
    if (repeatsPaper(arguments))
        return {paperTrials(arguments, options), wanted.measures};
    return {{sceneTrial(arguments, options)}, wanted.measures};
}

Against parsedAgainst(const ParsedArguments& arguments)
{
    if (!arguments.has(QStringLiteral("against-paper")))
        return Against::Nothing;
    if (!repeatsPaper(arguments))
        throw WrongUsage{Text::tr("--against-paper needs --paper table1, table2 or all.")};
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
