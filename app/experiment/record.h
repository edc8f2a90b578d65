// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/experiment.h"
#include "app/experiment/ranking.h"
#include "app/tables/table.h"

namespace app {

/// What was measured, how, and on what: all that tables, charts and reports show.
struct Record {
    ExperimentOptions options;
    QString easel; ///< what drew, and by which clock if by another; empty where nothing was drawn
    std::vector<std::pair<QString, QString>> circumstances;
    std::vector<Timing> timings;
};

/// Nothing if it was stopped.
std::optional<Record> recorded(const ExperimentOptions& options, std::span<const Variant> variants,
                               const Follower& follower = {});

/// One summary a timing, in their order.
std::vector<Summary> summaries(const Record& record, const Measure& measure);

std::vector<Variant> variantsOf(const Record& record);

/// The runs of each timing, which are paired by round, and what they say of who differs.
std::vector<std::vector<double>> runsOf(const Record& record, const Measure& measure);
Ranking rankingOf(const Record& record, const Measure& measure);

/// What is true of all lines: scene, how many, seed, space and window.
std::vector<std::pair<QString, QString>> factsOf(const ExperimentOptions& options);

/// What is true of all numbers of the record: of the lines, and runs, clock, machine ...
std::vector<std::pair<QString, QString>> factsOf(const Record& record);

/// One row a variant: what it needed, its place among the others, and what it found.
Table timesTable(const Record& record, const Measure& measure);

/// One row a variant, measure and run: seconds for all lines.
Table runsTable(const Record& record, std::span<const Measure> measures);

} // namespace app
