// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/experiment/study.h"

#include <QByteArray>
#include <QStringList>

// Each run of an experiment in a process of its own: in another one memory lies elsewhere, and the
// clock of the processor may be another, which decides some per cent of a time.

namespace app {

/// The plan of one run of a plan: with its lines, and with its variant first.
Plan planOfRun(Plan plan, std::size_t run);

/// The times of a study that is one run, for the process that asked for it.
QByteArray dataOfRun(const Study& study);

/// A program whose `bench` makes one run of a plan and prints its data: with these words and
/// `--one-run=N`.
struct RunProgram {
    QString path;
    QStringList words;
};

/// Measures the trials of a plan, a process for each run, one after another. Empty if it was
/// stopped; its process is killed.
Result<std::vector<Record>> recordsInProcesses(const Plan& plan, const RunProgram& program,
                                               const Follower& follower);

/// The study of a plan in processes of `program`, which is Clearcut itself. The error is empty if
/// it was stopped.
Result<Study> studyInProcesses(const Plan& plan, const QString& program,
                               const Follower& follower = {});

} // namespace app
