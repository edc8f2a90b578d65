// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/record_chart.h"
#include "app/experiment/study.h"

namespace app {

/// The bars of a trial by one measure, from low to high, beside the paper's if the trial repeats a
/// table of the paper, and the distribution of the single runs. All charts of a study have
/// different keys.
std::vector<Chart> chartsOf(const Trial& trial, const Measure& measure);

/// Times by class, and operations.
std::vector<Chart> chartsOf(const Explanation& explanation);

/// Every chart of a study, including the paper's charts of its own tables.
std::vector<Chart> chartsOf(const Study& study);

} // namespace app
