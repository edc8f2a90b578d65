// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/experiment/analysis.h"

namespace app {

/// The options of `bench` that define what is measured.
std::vector<Option> experimentOptions();

/// The parsed --measure: times and analyses.
struct Wanted {
    std::vector<Measure> measures;
    std::vector<Analysis> analyses;
};
Wanted parsedWanted(const ParsedArguments& arguments, const QString& otherwise);

/// The parsed options; throws WrongUsage, or Failure if a drawing cannot be read or the requested
/// draw target does not work. The draw target is created only if `wanted` draws.
ExperimentOptions parsedExperiment(const ParsedArguments& arguments, const Wanted& wanted);

/// The parsed --precision; throws WrongUsage together with options that need double.
Precision parsedPrecision(const ParsedArguments& arguments);

/// The forms of --form: both, the corrected one first, unless it names one.
std::vector<clipping::Form> parsedForms(const ParsedArguments& arguments);

/// The variants that the options name: both forms unless --form names one.
std::vector<Variant> parsedVariants(const ParsedArguments& arguments);

} // namespace app
