// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/operation_profile.h"
#include "app/experiment/paper_runs.h"
#include "app/experiment/record.h"

namespace app {

/// The results from the lowest median to the highest: bars relative to the lowest, with 95 %
/// confidence intervals; brackets join rows that do not differ significantly. With a table of the
/// paper, also the paper's averages relative to their lowest, as hollow markers and a second
/// column; bars are then relative to the lowest of the table's algorithms. If an algorithm has both
/// forms, the corrected form is compared.
Chart chartOf(const Record& record, const Measure& measure,
              const std::optional<PaperTable>& paper = {});

/// The distribution of the single runs: a box for each variant, in the order of medians, in
/// nanoseconds per line.
Chart boxPlotOf(const Record& record, const Measure& measure);

/// The paper's own chart of a table: its averages in seconds, from low to high. Brackets, which the
/// paper does not have, join algorithms whose runs do not differ significantly.
Chart chartOf(const PaperTable& paper);

/// Comparisons, additions, multiplications and divisions per line of the scene (as in promisedOf),
/// as parts of one bar, the fewest first.
Chart chartOf(const OperationProfile& profile);

/// Nanoseconds per line of each class, a panel for each class, all on one scale, ordered by the
/// cost of a line of the scene.
Chart chartOf(const ClassProfile& profile);

} // namespace app
