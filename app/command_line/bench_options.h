// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/experiment/experiment.h"

namespace app {

/// The options of `bench` that say what is measured.
std::vector<Option> experimentOptions();

/// What they ask for; throws WrongUsage, or Failure where a drawing cannot be read. Nothing is
/// drawn.
ExperimentOptions experimentGiven(const Given& given);

/// The algorithms and forms they name: both forms unless --form names one.
std::vector<Contestant> contestantsGiven(const Given& given);

/// What --measure names; `otherwise` if it is not given.
std::vector<Measure> measuresGiven(const Given& given, const QString& otherwise);

} // namespace app
