// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/csv/record_blocks.h"
#include "app/formats/csv/record_fields.h"
#include "app/formats/csv/row_reader.h"

namespace app::csv {

/// A row that is skipped; `why` continues "line 12 ".
struct BadRow {
    std::size_t line;
    QString why;
};
constexpr std::size_t mostBadRowsNamed = 10;

enum class BadRows : std::uint8_t { End, Skip };

/// Reads the lines of one block of a table after the other. Reuses its buffers.
class TableRows {
public:
    /// With BadRows::End, a bad row ends the reading. `rows` must outlive this object.
    TableRows(const RowReader& rows, BadRows bad)
        : rows_(rows), bad_(bad), fields_(rows.separator())
    {
    }

    /// Replaces the lines by those of this block. Throws Refused at a bad row that is not skipped;
    /// the lines then are those of the rows before it.
    void read(const RecordBlock& block);

    const std::vector<clipping::Segment>& lines() const { return lines_; }
    /// The row of a line, counted from 0 over the whole table, bad rows included.
    std::size_t rowOf(std::size_t line) const { return sources_[line].row; }
    /// How a line is drawn, as `lookColumns`.
    const std::string& lookOf(std::size_t line) const { return looks_[sources_[line].look]; }

    std::size_t badCount() const { return badCount_; }
    const std::vector<BadRow>& badRows() const { return badRows_; } ///< the first few

private:
    struct Source {
        std::size_t row;
        std::size_t look; ///< index in looks_
    };

    void readRow(std::string_view record, std::size_t line, std::size_t row);
    std::size_t lookOf(const Row& row, std::size_t line);

    const RowReader& rows_;
    BadRows bad_;
    RecordFields fields_;
    std::vector<clipping::Segment> lines_;
    std::vector<Source> sources_; ///< of the lines
    std::vector<std::string> looks_;
    std::string layer_, colour_, width_; ///< of the last look
    std::size_t badCount_ = 0;
    std::vector<BadRow> badRows_;
};

} // namespace app::csv
