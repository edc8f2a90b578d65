// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/report/study_files.h"

namespace app {

/// The options of `bench` that name files to write beside the tables: --report and --charts.
std::vector<Option> fileOptions();

/// A file that is to be written, and how: known before the work.
struct BenchFile {
    StudyFile kind;
    QString path;
};

/// What they ask for; throws WrongUsage where the ending of a name says nothing, and Failure where
/// its folder is missing.
std::vector<BenchFile> filesGiven(const Given& given);

/// Writes them, and says which on standard error; throws Failure.
void writeFiles(const std::vector<BenchFile>& files, const Study& study);

} // namespace app
