// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/difference_output.h"
#include "app/command_line/table_input.h"

// `clearcut compare` of a table of lines (csv), row by row: tables of any length, while they still
// come.

namespace app {

/// --skip-bad.
std::vector<Option> tableCompareOptions();
/// A sentence for the help, beside the limits of the formats.
QString tableCompareLimit();

/// Whether the table can be compared row by row: its window is given. Throws WrongUsage if it
/// cannot, but one of `tableCompareOptions` was given.
bool comparesTable(const ParsedArguments& arguments, const QString& input);

/// Compares the lines of the table `input` and writes what differs; throws Failure. Lines and
/// shapes are numbered by rows, bad ones included.
csv::TableStreamed compareTable(const ParsedArguments& arguments, const QString& input,
                                const ComparedAt& at, DifferenceOutput& output);

} // namespace app
