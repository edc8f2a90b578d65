// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/study.h"

// Each run of an experiment in a process of its own: in another one memory lies elsewhere, and the
// clock of the processor may be another, which decides some per cent of a time.

namespace app {

/// The plan of one run of a plan: with its lines, and with its variant first.
Plan planOfRun(Plan plan, std::size_t run);

/// Prints the times of a study that is one run, for the process that asked for it.
void printRun(const Study& study);

/// Measures the trials of a plan, a process for each run: this program with its own arguments and
/// `--one-run`. Throws Failure if one fails.
std::vector<Record> recordsInProcesses(const Plan& plan, const Follower& follower);

} // namespace app
