// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/parsed_arguments.h"
#include "app/tables/table.h"

namespace app {

/// The options of every command that prints tables: --format and --output.
std::vector<Option> tableOptions();

/// The target and format of tables, known before the work, so that a wrong usage is reported first.
struct TableOutput {
    TableFormat format;
    QString path; ///< empty or "-": standard output
};

/// The parsed --output and --format; without --format the name's ending decides. Throws WrongUsage.
TableOutput tableOutput(const ParsedArguments& arguments);

/// Replaces an existing file only by a complete new one; throws Failure.
void writeTables(const TableOutput& output, std::span<const Table> tables);

} // namespace app
