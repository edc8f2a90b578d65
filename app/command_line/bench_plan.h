// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/bench_options.h"
#include "app/experiment/study.h"

namespace app {

/// The options of `bench` for the paper's tables.
std::vector<Option> paperOptions();

/// The plan that the options of `bench` describe: one trial for each table of the paper and form,
/// or one on a scene; throws like parsedExperiment. Analyses are left to the caller.
Plan parsedPlan(const ParsedArguments& arguments, const Wanted& wanted);

/// Whether the paper's own numbers are requested.
Against parsedAgainst(const ParsedArguments& arguments);

/// The trial to explain: all variants of the plan, with the options of its first trial.
PlannedTrial explanationOf(const Plan& plan);

} // namespace app
