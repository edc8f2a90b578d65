// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/difference_rows.h"
#include "app/command_line/table.h"

namespace app {

/// The output of `clearcut compare`: a row for each line that differs, or only their number.
class DifferenceOutput {
public:
    /// All arguments must outlive this object.
    DifferenceOutput(const ComparedAt& at, const TableOutput& output, bool onlySummary);

    DifferenceRows::Form form() const;

    /// Calls `find` and writes what it gives; throws Failure. Rows of CSV are written at once. The
    /// other formats need all rows first, because these decide how wide the columns are.
    void write(const std::function<void()>& find);

    /// To be called by `find`: before the first rows, and with the rows of each part of the lines,
    /// in order. False if no more is wanted, because the reader of standard output has ended.
    bool begin();
    bool give(const DifferenceRows& rows);

    const DifferenceTotals& totals() const { return totals_; } ///< of all that was given
    /// "KWC as published loses 456 lines that exact keeps."
    QString summary() const;

private:
    bool csvRows() const { return form() == DifferenceRows::Form::Csv; }
    void writeTable() const;

    const ComparedAt& at_;
    const TableOutput& output_;
    const bool onlySummary_;
    QIODevice* out_ = nullptr; ///< for rows of CSV
    std::vector<QStringList> rows_;
    DifferenceTotals totals_;
};

} // namespace app
