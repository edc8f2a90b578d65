// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/accuracy.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/operation_profile.h"
#include "app/experiment/paper_tables.h"

namespace app {

/// One experiment to be made. For a table of the paper the variants are the table's, in one form.
struct PlannedTrial {
    std::optional<PaperTable> paper; ///< the table that it repeats, if any
    ExperimentOptions options;
    std::vector<Variant> variants;
};

/// A trial for each of these tables and forms; without `lines`, with as many as each table has.
std::vector<PlannedTrial> paperTrials(std::span<const PaperTable> papers,
                                      std::span<const clipping::Form> forms,
                                      const ExperimentOptions& options,
                                      std::optional<std::uint64_t> lines);

/// The measurements that explain the times: per class, the operation counts, and the accuracy.
struct Explanation {
    ClassProfile classes;
    OperationProfile operations;
    std::vector<Accuracy> accuracies;
};

/// Everything that one study measures, in the window or on the command line.
struct Plan {
    std::vector<PlannedTrial> trials;
    std::vector<Measure> measures;           ///< those that are reported
    std::optional<PlannedTrial> explained{}; ///< the trial to explain afterwards, if any
};

/// Sets the runs of each trial to the number that its variants need (usualRounds).
void takeUsualRuns(Plan& plan);

/// One completed experiment.
struct Trial {
    std::optional<PaperTable> paper;
    Record record;
};

/// All results of a study: what tables, charts and reports show.
struct Study {
    std::vector<Measure> measures;
    std::vector<Trial> trials;
    std::optional<Explanation> explanation{};
};

/// Roughly how long it takes on a typical machine.
double roughSeconds(const Plan& plan);

/// The study of a plan whose trials were measured already, a record for each: makes the rest. Empty
/// if it was stopped.
std::optional<Study> study(const Plan& plan, std::vector<Record> records,
                           const Follower& follower = {});

/// Empty if it was stopped. If nothing was visible, the measure of drawing alone is left out,
/// because its times are zero and have no ratio.
std::optional<Study> study(const Plan& plan, const Follower& follower = {});

/// "Table 1, as published", "Near miss": distinguishes the trials of a study.
QString nameOf(const Trial& trial);

/// Whether the paper's own numbers are shown beside ours.
enum class Against : std::uint8_t { Nothing, Paper };

/// The results of a trial by one measure: in the paper's layout for a table of the paper, otherwise
/// a row for each variant.
std::vector<Table> tablesOf(const Trial& trial, const Measure& measure, Against against);

/// Times by class, operations, accuracy.
std::vector<Table> tablesOf(const Explanation& explanation);

/// Every table of a study, as the other `tablesOf` give them, the paper's own numbers included; for
/// a table of the paper also the table with a row for each variant.
std::vector<Table> tablesOf(const Study& study);

/// The machine and software of the measurement: names and values.
Table circumstancesTable(const Study& study);

} // namespace app
