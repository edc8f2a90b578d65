// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/experiment/analysis.h"

namespace app {

/// The options of `bench` that define what is measured.
std::vector<Option> experimentOptions();

/// The parsed --measure: times and analyses.
struct Wanted {
    std::vector<Measure> measures;
    std::vector<Analysis> analyses;
};
Wanted wantedGiven(const Given& given, const QString& otherwise);

/// The parsed options; throws WrongUsage, or Failure if a drawing cannot be read or the requested
/// draw target does not work. The draw target is created only if `wanted` draws.
ExperimentOptions experimentGiven(const Given& given, const Wanted& wanted);

/// The parsed --precision; throws WrongUsage together with options that need double.
Precision precisionGiven(const Given& given);

/// The forms of --form: both, the corrected one first, unless it names one.
std::vector<clipping::Form> formsGiven(const Given& given);

/// The variants that the options name: both forms unless --form names one.
std::vector<Variant> variantsGiven(const Given& given);

} // namespace app
