// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/csv/block_cut.h"
#include "app/formats/csv/table_stream.h"

namespace app::csv {

struct TableCutOptions {
    CutRows rows;
    TableStreamOptions stream{};
};

struct TableCut {
    TableCounts counts;
    TableStreamed stream{}; ///< not complete if `give` returned false
};

/// Cuts the lines of a table, which `streamTable` reads, as app::cut does, and gives what
/// csv::write writes: a header, then the rows of each block in the order of the input, as soon as
/// the block is read and cut. The column `source` counts the rows of the input from 0, bad ones
/// included. `give` returns false if no more text is wanted. Throws Refused at a bad row after the
/// pieces of the rows before it were given.
TableCut cutTable(ByteSource source, const std::function<bool(std::string_view)>& give,
                  const TableCutOptions& options);

} // namespace app::csv
