// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/record_chart.h"
#include "app/experiment/study.h"

namespace app {

/// The bars of a trial by one measure, from low to high, beside the paper's if it repeats a table
/// of it, and how the single runs lie. No two charts of a study have the same key.
std::vector<Chart> chartsOf(const Trial& trial, const Measure& measure);

/// Times by class, and operations.
std::vector<Chart> chartsOf(const Explanation& explanation);

/// Every chart of a study, those that the paper draws of its own tables among them.
std::vector<Chart> chartsOf(const Study& study);

} // namespace app
