// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/experiment/analysis.h"

namespace app {

/// The options of `bench` that say what is measured.
std::vector<Option> experimentOptions();

/// What --measure names: times, and analyses.
struct Wanted {
    std::vector<Measure> measures;
    std::vector<Analysis> analyses;
};
Wanted wantedGiven(const Given& given, const QString& otherwise);

/// What they ask for; throws WrongUsage, or Failure where a drawing cannot be read or nothing can
/// draw as it is asked. The easel is made only if `wanted` draws.
ExperimentOptions experimentGiven(const Given& given, const Wanted& wanted);

/// What --precision says; throws WrongUsage beside options that need double.
Precision precisionGiven(const Given& given);

/// The forms that --form names: both, the corrected one first, unless it names one.
std::vector<clipping::Form> formsGiven(const Given& given);

/// The algorithms and forms they name: both forms unless --form names one.
std::vector<Variant> variantsGiven(const Given& given);

} // namespace app
