// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/csv/table_rows.h"

#include <memory>

namespace app::csv {

struct TableStreamOptions {
    BadRows bad = BadRows::End;
    std::size_t threads = 1;
    std::function<void(const BadRow&)> sayBad{}; ///< for the first bad rows, in order
    std::function<void()> stopSource{}; ///< ends the source's wait for bytes, on any thread
};

/// The work of one thread, which gets one block of lines after the other.
class BlockWork {
public:
    BlockWork() = default;
    virtual ~BlockWork() = default;
    BlockWork(const BlockWork&) = delete;
    BlockWork& operator=(const BlockWork&) = delete;

    /// Replaces the result by that of these lines, at the same time as other threads.
    virtual void work(const TableRows& rows) = 0;
    /// Gives the result away, in the order of the table and never at the same time as other
    /// threads. False if no more is wanted.
    virtual bool give() = 0;
};

struct TableStreamed {
    std::vector<Loss> report{}; ///< the columns that are not read
    std::size_t badRows = 0;
    /// False if no more was wanted, so that the rest was not read.
    bool complete = true;
};

/// Reads a table of lines as csv::read does, and hands each block of rows to one of the works as
/// soon as it is read. Memory does not grow with the number of lines. `begin` is called once the
/// header was read; false: nothing is wanted. Throws Refused at a bad row, unless these are
/// skipped, after the results of the rows before it were given.
TableStreamed streamTable(ByteSource source, const TableStreamOptions& options,
                          const std::function<bool()>& begin,
                          const std::function<std::unique_ptr<BlockWork>()>& newWork);

} // namespace app::csv
