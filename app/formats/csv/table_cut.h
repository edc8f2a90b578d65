// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/csv/block_cut.h"

namespace app::csv {

struct TableCut {
    TableCounts counts;
    std::vector<Loss> report{};
    /// False if `give` returned false, so that the rest was not read.
    bool complete = true;
};

/// Reads a table of lines as csv::read does, cuts them as app::cut does, and gives what csv::write
/// writes: a header, then the rows of each block in the order of the input, as soon as the block
/// is read and cut. Memory does not grow with the number of lines. The column `source` counts the
/// rows of the input from 0, bad ones included. `give` returns false if no more text is wanted.
/// Throws Refused at a bad row after the pieces of the rows before it were given.
TableCut cutTable(ByteSource source, const std::function<bool(std::string_view)>& give,
                  const TableCutOptions& options);

} // namespace app::csv
