// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/drawing_files.h"
#include "app/cut/cut.h"

// `clearcut clip` from CSV to CSV, row by row: tables of any length, while they still come.

namespace app {

/// --skip-bad and --rows-only: how tables are cut.
std::vector<Option> tableClipOptions();
/// A sentence for the help, beside the limits of the formats.
QString tableLimit();

/// Whether the table can be cut row by row: no option needs all lines at once. Throws WrongUsage if
/// it cannot, but one of `tableClipOptions` was given.
bool clipsTable(const ParsedArguments& arguments, const QString& input, const Output& output);

/// Cuts the table `input`; throws Failure. Prints the report of `clip`. If the reader of standard
/// output has ended, nothing more is read or reported.
void clipTable(const ParsedArguments& arguments, const QString& input, const Output& output,
               const CutOptions& options);

} // namespace app
