// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/paper_runs.h"
#include "app/experiment/ranking.h"
#include "app/experiment/record.h"

namespace app {

/// "Table 1", "Table 2".
QString numberOf(const PaperTable& paper);

/// "lines of the scene “Long”" if the lines are not generated as in the paper; otherwise empty.
QString otherLinesText(const ExperimentOptions& options);

/// One sentence if our work differs from the paper's: another measure than the total, other lines,
/// or another number of lines. Empty if it is the same.
QString otherWorkText(const PaperTable& paper, const ExperimentOptions& options,
                      const Measure& measure);

/// The algorithms of a table of the paper in one form, in the table's order.
std::vector<Variant> variantsOf(const PaperTable& paper, clipping::Form form);

/// Our measurements in the paper's layout: a row for each run and one for averages, in seconds for
/// all lines, a column for each algorithm, CS to Prop. The record's variants are those of the
/// table.
Table paperLayout(const PaperTable& paper, const Record& record, const Measure& measure);

/// The paper's own numbers in the same layout.
Table paperLayout(const PaperTable& paper);

/// The paper's averages and ours, how much faster the proposed method is by both definitions, and
/// the ranks and letters. The paper's runs are tested in the same way as ours.
Table againstPaper(const PaperTable& paper, const Record& record, const Measure& measure);

/// Which algorithms differ significantly in the paper's own runs, if run r of every algorithm is
/// paired with run r of the others.
Ranking rankingOf(const PaperTable& paper);

/// The sentence that states this assumption.
QString paperPairingText();

} // namespace app
