// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"
#include "app/tables/table.h"

namespace app {

/// The options of every command that prints tables: --format and --output.
std::vector<Option> tableOptions();

/// Where tables go, and as what: known before the work, so that a wrong usage is said at once.
struct TableOutput {
    TableFormat format;
    QString path; ///< empty or "-": standard output
};

/// What --output and --format say; without --format the name's ending tells. Throws WrongUsage.
TableOutput tableOutput(const Given& given);

/// Throws Failure; what is there is lost only to a whole new file.
void writeTables(const TableOutput& output, std::span<const Table> tables);

} // namespace app
