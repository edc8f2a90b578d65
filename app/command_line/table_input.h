// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/drawing_files.h"
#include "app/command_line/input_bytes.h"
#include "app/formats/csv/table_stream.h"

// A table of lines as the input of a command that reads it row by row, while it still comes.

namespace app {

/// --skip-bad, of which `meaning` says when it can be given.
Option skipBadOption(const QString& meaning);

/// Stands for the table when options are read: no lines, and the unit of all tables.
Imported tableWithoutLines();

/// Hands the source and the options on to csv::streamTable.
using StreamsTable = std::function<csv::TableStreamed(csv::ByteSource, csv::TableStreamOptions)>;

/// Lets `stream` read the table, with as many threads as are useful; throws Failure, also at a bad
/// row. Without --quiet, bad rows that are skipped are reported as they come.
csv::TableStreamed streamed(InputBytes& in, const ParsedArguments& arguments,
                            const StreamsTable& stream);

/// Reports the number of bad rows, if any were skipped.
void sayBadRows(const csv::TableStreamed& streamed);

} // namespace app
