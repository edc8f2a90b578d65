// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/report/study_files.h"

namespace app {

/// The options of `bench` for files besides the tables: --report and --charts.
std::vector<Option> fileOptions();

/// A file to be written and its format, known before the measurement.
struct BenchFile {
    StudyFile kind;
    QString path;
};

/// The files that these options name; throws WrongUsage for an unknown ending of a name, and
/// Failure if a folder is missing.
std::vector<BenchFile> parsedFiles(const ParsedArguments& arguments);

/// Writes the files and reports their names on standard error; throws Failure.
void writeFiles(const std::vector<BenchFile>& files, const Study& study);

} // namespace app
