// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/accuracy.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/operation_profile.h"
#include "app/experiment/paper_tables.h"

namespace app {

/// One experiment that is to be made. For a table of the paper the variants are the table's, in
/// one form.
struct PlannedTrial {
    std::optional<PaperTable> paper; ///< the table that it repeats, if it does
    ExperimentOptions options;
    std::vector<Variant> variants;
};

/// A trial for each of these tables and forms; without `lines`, as many as each table has.
std::vector<PlannedTrial> paperTrials(std::span<const PaperTable> papers,
                                      std::span<const clipping::Form> forms,
                                      const ExperimentOptions& options,
                                      std::optional<std::uint64_t> lines);

/// What explains times: what a line of each class costs, the arithmetic, and the truth of results.
struct Explanation {
    ClassProfile classes;
    OperationProfile operations;
    std::vector<Accuracy> accuracies;
};

/// All that is to be measured in one go, by the window or the command line.
struct Plan {
    std::vector<PlannedTrial> trials;
    std::vector<Measure> measures;           ///< what is told of their times
    std::optional<PlannedTrial> explained{}; ///< what is explained after them, if anything
};

/// Each trial runs as often as its variants need (usualRounds).
void takeUsualRuns(Plan& plan);

/// One experiment that was made.
struct Trial {
    std::optional<PaperTable> paper;
    Record record;
};

/// All that was measured in one go: what tables, charts, and reports tell.
struct Study {
    std::vector<Measure> measures;
    std::vector<Trial> trials;
    std::optional<Explanation> explanation{};
};

/// About how long it takes on a usual machine.
double roughSeconds(const Plan& plan);

/// Nothing if it was stopped. Where nothing was visible, the time of drawing alone is not told: it
/// was none, and nothing is so many times as long.
std::optional<Study> study(const Plan& plan, const Follower& follower = {});

/// "Table 1, as published", "Near miss": to tell the trials of a study apart.
QString nameOf(const Trial& trial);

/// Whether the paper's own numbers are set beside ours.
enum class Against : std::uint8_t { Nothing, Paper };

/// What a trial says by one measure: the paper's layout for a table of the paper, else a row a
/// variant.
std::vector<Table> tablesOf(const Trial& trial, const Measure& measure, Against against);

/// Times by class, operations, accuracy.
std::vector<Table> tablesOf(const Explanation& explanation);

/// Every table of a study, as `tablesOf` has them, the paper's own numbers among them; and for a
/// table of the paper the row a variant, too.
std::vector<Table> tablesOf(const Study& study);

/// On what, and with what, it was measured: names and what they stand for.
Table circumstancesTable(const Study& study);

} // namespace app
