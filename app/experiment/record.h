// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/experiment.h"
#include "app/experiment/ranking.h"
#include "app/tables/table.h"

namespace app {

/// What was measured, how, and on which machine: everything that tables, charts and reports show.
struct Record {
    ExperimentOptions options;
    QString target; ///< name of the draw target, and of its clock if different; empty: no drawing
    std::vector<std::pair<QString, QString>> circumstances;
    std::vector<Timing> timings;
};

/// Empty if it was stopped.
std::optional<Record> recorded(const ExperimentOptions& options, std::span<const Variant> variants,
                               const Follower& follower = {});

/// One summary for each timing, in their order.
std::vector<Summary> summaries(const Record& record, const Measure& measure);

std::vector<Variant> variantsOf(const Record& record);

/// The runs of each timing, paired by round, and the ranking that follows from them.
std::vector<std::vector<double>> runsOf(const Record& record, const Measure& measure);
Ranking rankingOf(const Record& record, const Measure& measure);

/// Facts about the lines: scene, number, seed, space and window.
std::vector<std::pair<QString, QString>> factsOf(const ExperimentOptions& options);

/// Facts that hold for the whole record: those about the lines, and runs, clock, machine, ...
std::vector<std::pair<QString, QString>> factsOf(const Record& record);

/// One sentence on `exact`, which is timed in batches, with its times in batches and line by line;
/// empty without both.
QString batchText(const Record& record);

/// A row for each variant: its times, its rank, and its findings.
Table timesTable(const Record& record, const Measure& measure);

/// The columns of timesTable() that matter most, the fastest variant first: rank, time, ratio and
/// lost lines; of the facts, lines, runs, processor and compiler.
Table briefTimesTable(const Record& record, const Measure& measure);

/// A row for each variant, measure and run: seconds for all lines.
Table runsTable(const Record& record, std::span<const Measure> measures);

} // namespace app
