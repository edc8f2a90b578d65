// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/paper_runs.h"
#include "app/experiment/ranking.h"
#include "app/experiment/record.h"

namespace app {

/// "Table 1", "Table 2".
QString numberOf(const PaperTable& paper);

/// "lines of the scene “Long”" where lines are not made as the paper's; empty where they are.
QString otherLinesText(const ExperimentOptions& options);

/// One sentence where ours is not the work that the paper timed: by another measure than the total,
/// with other lines, or with fewer or more of them. Empty where it is the same.
QString otherWorkText(const PaperTable& paper, const ExperimentOptions& options,
                      const Measure& measure);

/// The algorithms of a table of the paper in one form, in its order.
std::vector<Variant> variantsOf(const PaperTable& paper, clipping::Form form);

/// What we measured, as the paper prints it: a row a run and one of averages, in seconds for all
/// lines, a column an algorithm, CS to Prop. The record's variants are those of the table.
Table paperLayout(const PaperTable& paper, const Record& record, const Measure& measure);

/// The same numbers of the paper itself.
Table paperLayout(const PaperTable& paper);

/// The paper's averages and ours, how much faster the proposed method is by both definitions, and
/// the ranks and letters, which the paper's runs get by the same tests as ours.
Table againstPaper(const PaperTable& paper, const Record& record, const Measure& measure);

/// What the paper's own runs say of who differs, taken as if run r of every algorithm was made in
/// the same round.
Ranking rankingOf(const PaperTable& paper);

/// The sentence that says so.
QString paperPairingText();

} // namespace app
