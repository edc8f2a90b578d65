// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/operation_profile.h"
#include "app/experiment/paper_runs.h"
#include "app/experiment/record.h"

namespace app {

/// What was measured, from the lowest median to the highest: bars in times of the lowest, with
/// their 95 % confidence; brackets join what does not differ significantly. With a table of the
/// paper, its averages in times of its lowest, as hollow markers and a second column; bars are in
/// times of the lowest of the algorithms that it has, then. One that comes in both forms is
/// compared in its corrected one.
Chart chartOf(const Record& record, const Measure& measure,
              const std::optional<PaperTable>& paper = {});

/// How the single runs lie: a box a variant, in the order of the medians, nanoseconds a line.
Chart boxPlotOf(const Record& record, const Measure& measure);

/// The chart that the paper draws of a table: its own averages in seconds, from low to high, with
/// brackets of what its runs do not tell apart, which the paper does not say.
Chart chartOf(const PaperTable& paper);

/// Comparisons, additions, multiplications and divisions a line of the scene (what promisedOf
/// counts), as parts of one bar, the fewest first.
Chart chartOf(const OperationProfile& profile);

/// Nanoseconds a line of each class, a panel a class, all on one scale; in the order of what a line
/// of the scene costs.
Chart chartOf(const ClassProfile& profile);

} // namespace app
